// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <vector>

namespace barreno {

/// Seconds since its making.
class Stopwatch {
public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// What this rank's particles have cost since the ranks last compared it. Measured, and therefore
/// only ever used to say who works on what: answers do not depend on it.
struct Effort {
  /// Seconds of the particle updates: per set, per block of rows (base/rows.hpp). Rows that are
  /// near in storage are near in space, so a block tells what its part of the scene costs.
  std::vector<std::vector<double>> block_seconds;
  double node_seconds = 0.0;  ///< of projection and interpolation, the same for every awake row
  double tile_seconds =
      0.0;  ///< of cells and nodes, the same for every active tile, dormant or not

  void add(std::size_t set, std::size_t block, double seconds) {
    if (block_seconds.size() <= set) block_seconds.resize(set + 1);
    if (block_seconds[set].size() <= block) block_seconds[set].resize(block + 1, 0.0);
    block_seconds[set][block] += seconds;
  }
  double seconds(std::size_t set, std::size_t block) const {
    return set < block_seconds.size() && block < block_seconds[set].size()
               ? block_seconds[set][block]
               : 0.0;
  }
  double particle_seconds() const {
    double sum = 0.0;
    for (const auto& set : block_seconds)
      for (const double seconds : set) sum += seconds;
    return sum;
  }
};

/// What ranks lose by how the tiles are shared, and what changing that costs: they change when they
/// have lost as much. The same on all ranks.
struct LoadBalance {
  double waited_seconds =
      0.0;  ///< for the rank with the most to do, since tiles last changed hands
  double change_seconds = 0.0;  ///< that a change takes; 0: there was none yet
};

}  // namespace barreno
