// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output/output.hpp"
#include "scene/scene.hpp"
#include "state/effort.hpp"
#include "state/state.hpp"

#include <string>

namespace barreno {

/// When a run's checkpoints are written: every so many steps, so much simulated time or so many
/// seconds, by Output in the deck, and where a run ends or is interrupted.
///
/// A checkpoint changes nothing in the run: particles are sorted afresh behind it, which leaves
/// every bit as it is but in steps that also move rows in memory, and so none is written before
/// one. The pore flow's solver starts afresh behind a checkpoint as it does in a resumed run.
class Checkpoints {
public:
  Checkpoints(const Scene& scene, const RunDescription& run);

  /// Call after every step and its output. Collective.
  void write_if_due(Output& output, State& state);
  /// Whether the present step is one behind which a checkpoint may be written.
  static bool may_write(const State& state);
  /// A disk that is full is a warning: the run goes on and the last good file stays.
  /// Collective
  void write(Output& output, State& state);
  /// The checkpoint with which a run ends. @return why it could not be written; empty: it was.
  /// Collective
  std::string write_last(Output& output, State& state);

private:
  bool is_due(const State& state);

  CheckpointSpec spec_;
  std::filesystem::path folder_;
  std::string deck_text_;
  Continued continued_;
  Stopwatch watch_;      ///< since the last checkpoint
  long last_step_ = -1;  ///< of the last checkpoint, or the first step seen
  double last_time_ = 0.0;
};

}  // namespace barreno
