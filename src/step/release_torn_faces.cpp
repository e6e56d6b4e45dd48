// SPDX-License-Identifier: BSD-3-Clause
#include "step/release_torn_faces.hpp"

#include "base/region.hpp"
#include "shape/kinematics.hpp"

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

}  // namespace

void release_torn_faces(const Scene& scene, State& state) {
  if (scene.loads.empty()) return;
  const Region region("release_torn_faces");
  state.loaded_tiles.assign(static_cast<std::size_t>(state.grid.active), 0);
  const int bits = state.grid.patch.tile_bits * state.grid.patch.dimensions;
  visit_mode(scene.grid.mode, [&](auto mode) {
    for (Particles& particles : state.particles) {
      if (particles.loaded_faces.components == 0) continue;
      for (int p = 0; p < particles.count; ++p) {
        if (particles.loaded_faces(p) == 0.0) continue;
        if (torn<decltype(mode)>(scene, particles, p)) {
          particles.loaded_faces(p) = 0.0;
          state.ledger.unloaded += 1.0;
        } else {
          state.loaded_tiles[static_cast<std::size_t>(particles.key(p) >> bits)] = 1;
        }
      }
    }
  });
}

}  // namespace barreno
