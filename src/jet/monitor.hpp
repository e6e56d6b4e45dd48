// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"
#include "base/run_numbers.hpp"
#include "jet/table.hpp"
#include "state/state.hpp"

#include <set>

namespace barreno {

/// Watches the plane of a Jet Monitor: a particle crosses once, and when it is first seen beyond
/// the plane, its velocity says when it was there. It looks at every step, so that nothing leaves
/// the grid beyond the plane unseen.
class JetMonitor {
public:
  /// @param position  numbers() of a run that is resumed
  JetMonitor(const JetMonitorSpec& monitor, const RunNumbers& position);

  bool on() const { return monitor_.present(); }
  /// Collective, after every step: the root notes the particles that have come.
  void watch(const State& state);
  /// Of the monitored bodies, ahead of the plane. Collective.
  double mass_beyond(const State& state) const;

  /// What a checkpoint must hold; valid on the root.
  RunNumbers numbers() const;
  /// In order of time and id; valid on the root.
  const std::vector<JetCrossing>& crossings() const { return crossings_; }
  const JetMonitorSpec& spec() const { return monitor_; }

private:
  void note(const std::vector<double>& numbers, double now);

  JetMonitorSpec monitor_;
  double last_ = 0.0;  ///< look [time]
  std::vector<JetCrossing> crossings_;
  std::set<ParticleId> known_;  ///< of crossings_
  std::set<ParticleId> told_;   ///< by this rank: it does not tell the root twice
};

}  // namespace barreno
