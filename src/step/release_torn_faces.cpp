// SPDX-License-Identifier: BSD-3-Clause
#include "step/release_torn_faces.hpp"

#include "base/region.hpp"
#include "shape/kinematics.hpp"

#include <vector>

namespace barreno {
namespace {

/// A face of a particle that is stretched to more than this belongs to no surface any more.
constexpr double torn_stretch = 2.0;

/// A pressure on a surface of a ball acts inside its particles, however they are stretched.
bool is_in_ball(const Scene& scene, const Particles& particles, int p) {
  const auto body = static_cast<std::size_t>(particles.body(p) & ~held_bit);
  return std::holds_alternative<Ball>(scene.bodies[body].shape);
}

template <class M>
bool torn(const Scene& scene, const Particles& particles, int p) {
  if ((particles.body(p) & held_bit) != 0) return true;
  if (particles.surface_share.components > 0 && is_in_ball(scene, particles, p)) return false;
  const auto f = load_tensor<M>(particles.deformation_gradient.values, p);
  return largest_stretch(f) > torn_stretch;
}

/// Ends the loads of what is torn. What has not changed is not: tiles that keep their sums.
/// @param[in,out] loaded_tiles  1 for the tiles of what is still loaded
/// @return particles that lost their loads
template <class M>
double release_set(
    const Scene& scene,
    const Patch& patch,
    const Nodes& nodes,
    Particles& particles,
    std::vector<unsigned char>& loaded_tiles
) {
  double released = 0.0;
  for (int p = 0; p < particles.count; ++p) {
    if (particles.loaded_faces(p) == 0.0) continue;
    const int tile = tile_of(patch, particles, p);
    if (!nodes.keeps(tile) && torn<M>(scene, particles, p)) {
      particles.loaded_faces(p) = 0.0;
      released += 1.0;
    } else {
      loaded_tiles[static_cast<std::size_t>(tile)] = 1;
    }
  }
  return released;
}

}  // namespace

void release_torn_faces(const Scene& scene, State& state) {
  if (scene.loads.empty()) return;
  const Region region("release_torn_faces");
  const Grid& grid = state.grid;
  state.loaded_tiles.assign(static_cast<std::size_t>(grid.active), 0);
  visit_mode(scene.grid.mode, [&](auto mode) {
    for (Particles& particles : state.particles)
      if (particles.loaded_faces.components > 0)
        state.ledger.unloaded += release_set<decltype(mode)>(
            scene,
            grid.patch,
            state.nodes[static_cast<std::size_t>(particles.field)],
            particles,
            state.loaded_tiles
        );
  });
}

}  // namespace barreno
