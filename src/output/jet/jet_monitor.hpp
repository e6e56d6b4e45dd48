// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"
#include "base/run_numbers.hpp"
#include "output/jet/jet_table.hpp"
#include "output/schedule.hpp"
#include "state/state.hpp"

#include <set>

namespace barreno {

/// Watches the plane of a Jet Monitor: a particle crosses once, and when it is first seen beyond
/// the plane, after at most an eighth of an interval, its velocity says when it was there.
class JetMonitor {
public:
  /// @param position  numbers() of a run that is resumed
  JetMonitor(const JetMonitorSpec& monitor, const RunNumbers& position);

  bool on() const { return monitor_.present(); }
  /// Collective: the root notes the particles that have come.
  void watch_if_due(const State& state);
  void watch(const State& state);

  /// What a checkpoint must hold; valid on the root.
  RunNumbers numbers() const;
  /// In order of time and id; valid on the root.
  const std::vector<JetCrossing>& crossings() const { return crossings_; }
  const JetMonitorSpec& spec() const { return monitor_; }
  double mass_beyond() const { return mass_beyond_; }  ///< at the last look; valid on the root

private:
  JetMonitorSpec monitor_;
  Schedule looks_;
  double last_ = 0.0;  ///< look [time]
  double mass_beyond_ = 0.0;
  std::vector<JetCrossing> crossings_;
  std::set<ParticleId> known_;
};

}  // namespace barreno
