// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

/// What this rank has done outside of the steps since the start of the process: work of which each
/// rank should have its part alone. summary.json tells the sums and the rank with the most.
struct WorkCounts {
  long long candidate_points = 0;  ///< places looked at, of boxes and lattices, to fill bodies
  /// Places, tiles and cells that every rank looks at in the whole scene, however many ranks there
  /// are: along the axes of boxes, at surfaces that are checked, where a detonation arrives.
  long long undivided_points = 0;
  long long particles_made = 0;    ///< of bodies, kept by this rank
  long long checkpoint_bytes = 0;  ///< of a checkpoint, read to compare its seal or for its rows
};
inline WorkCounts& work_counts() {
  static WorkCounts counts;
  return counts;
}

}  // namespace barreno
