// SPDX-License-Identifier: BSD-3-Clause
#include "step/particles/move_particles.hpp"

#include "base/region.hpp"
#include "shape/kinematics.hpp"
#include "state/row_frames.hpp"

namespace barreno {

namespace {

template <class M, bool Short>
struct MoveParticles {
  FieldView position, grid_motion, increment;
  RowFrames frames;

  KOKKOS_INLINE_FUNCTION void operator()(int p) const {
    for (int d = 0; d < M::dimensions; ++d) {
      if (M::hoop && d == 0)
        position(p, 0) *= exponential<Short>(increment(p, 4));
      else
        position(p, d) += frames.dt(p) * grid_motion(p, d);
    }
  }
};

}  // namespace

void move_particles(const Grid& grid, Rows rows, Particles& particles) {
  const Region region("move_particles");
  visit_mode(grid.mode, [&](auto mode) {
    using M = decltype(mode);
    const auto move = [&](auto short_strain) {
      for_each_row(
          "move_particles",
          rows,
          MoveParticles<M, decltype(short_strain)::value>{
              particles.position.values,
              particles.grid_motion.values,
              particles.increment.values,
              RowFrames(grid, particles)}
      );
    };
    if (!M::hoop || all_short(particles.increment.values, rows, 4, 5))
      move(std::true_type{});
    else
      move(std::false_type{});
  });
}

}  // namespace barreno
