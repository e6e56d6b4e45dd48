// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"
#include "files/text_file.hpp"
#include "jet/path.hpp"
#include "jet/rock_zones.hpp"
#include "scene/scene.hpp"
#include "state/state.hpp"

#include <memory>
#include <vector>

namespace barreno {

/// How far the jet has come. None of the numbers depends on the rank count or on the order of
/// particles.
struct Penetration {
  bool met = false;  ///< jet material is beyond the target's outer face
  /// Depth of the leading edge of the deepest jet particle, its box undeformed; 0 until it has met
  /// the target, the length of the target once it is through [length].
  double depth = 0.0;
  bool through = false;  ///< jet material has come out of the rear of the target, once for all
  double through_since = 0.0;  ///< when that was first seen; 0: it has not [time]
  /// Length of the channel that is open from the outer face on: whole rows of one cell, the
  /// smallest of the grid, along the axis, open while the wall of the row or of the next one is at
  /// least a quarter of a cell away from the axis, so that crumbs in the channel, which fill one of
  /// them and then none, do not close it [length].
  double channel_depth = 0.0;
  /// How far the channel is as wide as the widest slug: whole rows, as long as the walls of most
  /// rows within five of the slug's diameters on either side are at least as far from the axis as
  /// its rim. Necks no longer than that do not count: they come and go. Behind it a thread of spent
  /// metal may go on, whose length follows the size of the cells (docs/trade.md, Depth at rest)
  /// [length].
  double probed_depth = 0.0;
  double probed_volume = 0.0;  ///< of the channel down to there; plane strain: area [length^3]
  /// Distance from the axis to the wall, at half the channel depth; 0 without a channel,
  /// the width of the grid if there is no target [length]. The wall is where the target's
  /// particles, as they are deformed, fill half of a window one cell wide and high, as in the
  /// report: for a sharp wall that is the wall itself, wherever it lies in its cell.
  double channel_radius_mid = 0.0;
  std::vector<double> walls;  ///< the same of every row from the outer face on [length]
  /// Mass of the jet particles whose centre is beyond the outer face of a target [mass].
  double jet_mass_inside = 0.0;
  /// Velocity along the jet's direction of the particle that reaches deepest, in free flight too; 0
  /// before the first launch [length/time].
  double tip_velocity = 0.0;
};

/// Collective; the result is valid on the root.
Penetration measure_penetration(const Scene& scene, const State& state, const JetPath& path);

/// depth.csv, a row per call.
class DepthWriter {
public:
  DepthWriter(
      JetPath path,
      const Comm& comm,
      const std::filesystem::path& file,
      std::uintmax_t kept = 0,
      double through_since = 0.0
  );
  /// Collective; last() without a row.
  void measure(const Scene& scene, const State& state);
  /// Collective. @throws FileError on every rank
  void write(const Scene& scene, const State& state);
  const Penetration& last() const { return last_; }  ///< valid on the root
  /// Of the channel that was measured last. Collective.
  std::vector<RockZones> zones(const Scene& scene, const State& state) const;
  double through_since() const { return through_since_; }  ///< valid on the root; 0: it is not

  std::uintmax_t bytes() const { return file_ ? file_->bytes() : 0; }

private:
  JetPath path_;
  double through_since_;
  std::unique_ptr<LineFile> file_;  ///< root only
  Penetration last_;
};

}  // namespace barreno
