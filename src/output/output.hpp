// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/build_facts.hpp"
#include "base/run_numbers.hpp"
#include "deck/deck.hpp"
#include "deck/sections/continue_section.hpp"
#include "deck/sections/jet_monitor_section.hpp"
#include "output/prediction.hpp"
#include "scene/scene.hpp"
#include "state/continued.hpp"
#include "state/id_ranges.hpp"
#include "state/state.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace barreno {

/// What the output must know beside scene and state.
struct RunDescription {
  std::filesystem::path folder;  ///< exists, see create_run_folder
  std::string deck_name;         ///< as the user typed it
  std::string deck_text;         ///< the effective deck: re-runnable, written as deck.xml
  std::string version;
  std::vector<std::string> notes;       ///< further lines for the first block on the screen
  Prediction prediction{};              ///< of its cost
  std::vector<SurfaceFile> surfaces{};  ///< that deck.xml names, to be copied beside it
  BuildFacts build{};                   ///< of the program, see build_facts
  JetMonitorSpec monitor{};             ///< not present() without a Jet Monitor
  std::vector<IdRange> ids{};           ///< of all particles, see particle_id_ranges
  ContinueSpec continued_run{};         ///< the run that it continues, as the deck names it
  Continued continued{};                ///< not on() unless the run continues another one
};

/// How a run ended.
struct RunVerdict {
  bool finished = false;
  std::string reason;  ///< one sentence; empty if finished
  int exit_code = 0;
  bool may_be_resumed = false;  ///< not finished, and nothing is wrong with the computation
  bool files_failed = false;    ///< the disk took no more
  bool at_rest = false;         ///< finished before the end time, with the hole of the jet at rest
};

/// All files of a run and the screen. The files' contents do not depend on the rank count.
///
/// Every function is collective: a file that cannot be written is a FileError on every rank.
class Output {
public:
  /// Prints the first block and opens the files; the state is that at t = 0, or of the checkpoint.
  /// @param position  of a run that is resumed, see position(): its files stay as they were there.
  ///                  Also its "time", and with hollow balls "radii_start" (start_of_radii)
  Output(
      const Scene& scene,
      const State& state,
      const RunDescription& run,
      const RunNumbers& position = {}
  );
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Fields at multiples of the field interval, history and depth at theirs, progress; call at the
  /// start and after every step.
  void write_if_due(const Scene& scene, const State& state);

  /// The next instant after `now` that a step must end on: a field output or the end of the run
  /// [time].
  double next_time(double now) const;

  /// Whether a run to rest has come to its end: the hole was at rest at the last row of depth.csv.
  bool at_rest() const;

  /// A warning that every rank gives alike: printed once for each `kind`, later ones are counted.
  void warn(const std::string& kind, const std::string& sentence);

  /// From now on nothing is written but the screen and, if the disk takes it, summary.json: after a
  /// FileError.
  void give_up_files();

  /// How far the files have come in whole outputs, and the clock on the wall, for a checkpoint.
  /// Valid on the root.
  RunNumbers position() const;
  /// Called once where a run is resumed: the content of its state has been reported before, and
  /// what could not be written of its step is written now.
  void go_on_from(const Scene& scene, const State& state);
  double seconds() const;  ///< of work, those before a resume included; valid on the root

  /// Last fields and rows, summary.json, and the last block on the screen.
  void finish(const Scene& scene, const State& state, const RunVerdict& verdict);

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace barreno
