// SPDX-License-Identifier: BSD-3-Clause
#include "step/boundary/move_rigid_particles.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"

#include <cmath>
#include <limits>

namespace barreno {
namespace {

struct MoveRigidParticles {
  RigidMotions motions;
  double time;
  ArrayView<TileFrame> tile_frame;
  Particles particles;

  KOKKOS_INLINE_FUNCTION void operator()(int tile, double& least) const {
    const int begin = particles.tile_begin(tile);
    const int end = particles.tile_begin(tile + 1);
    if (begin == end) return;
    const double cell_size = tile_frame(tile).cell_size;
    const double dt = tile_frame(tile).dt;
    double velocity[3];
    motions.over_step(motions.of_field[particles.field], time, dt, velocity);
    double squared = 0.0;
    for (int d = 0; d < particles.position.components; ++d) {
      const double component = velocity[d];
      for (int k = begin; k < end; ++k) {
        const int p = particles.order(k);
        particles.velocity(p, d) = component;
        particles.position(p, d) += dt * component;
      }
      squared += component * component;
    }
    if (squared > 0.0) least = std::fmin(least, 0.5 * cell_size / std::sqrt(squared));
  }
};

}  // namespace

double move_rigid_particles(
    const RigidMotions& motions, double time, const Grid& grid, Particles& particles
) {
  const Region region("move_rigid_particles");
  double least = 0.0;
  launch_reduction(
      "move_rigid_particles",
      range(grid.active),
      MoveRigidParticles{motions, time, grid.tile_frame, particles},
      Kokkos::Min<double>(least)
  );
  const bool bounded = least < std::numeric_limits<double>::max();  // which is Kokkos's start
  return bounded ? least : std::numeric_limits<double>::infinity();
}

}  // namespace barreno
