// SPDX-License-Identifier: BSD-3-Clause
#include "step/move_particles.hpp"

#include "base/region.hpp"
#include "shape/kinematics.hpp"

namespace barreno {

ParticleTally move_particles(const Scene& scene, double dt, Rows rows, Particles& particles) {
  const Region region("move_particles");
  const double pic = scene.step.pic_fraction;
  const double flip = 1.0 - pic;
  const Particles p_ = particles;
  ParticleTally tally;
  visit_mode(scene.grid.mode, [&](auto mode) {
    using M = decltype(mode);
    Kokkos::parallel_reduce(
        "move_particles",
        range(rows),
        KOKKOS_LAMBDA(const int p, double& before, double& after, double& mass, double& momentum) {
          const double m = p_.mass(p);
          const double vx = p_.velocity(p, 0);
          const double vy = p_.velocity(p, 1);
          const double wx = flip * (vx + p_.grid_motion(p, 2)) + pic * p_.grid_motion(p, 0);
          const double wy = flip * (vy + p_.grid_motion(p, 3)) + pic * p_.grid_motion(p, 1);
          before += 0.5 * m * (vx * vx + vy * vy);
          after += 0.5 * m * (wx * wx + wy * wy);
          mass += m;
          momentum += m * wy;
          p_.velocity(p, 0) = wx;
          p_.velocity(p, 1) = wy;
          if (M::hoop)
            p_.position(p, 0) *= std::exp(p_.increment(p, 4));
          else
            p_.position(p, 0) += dt * p_.grid_motion(p, 0);
          p_.position(p, 1) += dt * p_.grid_motion(p, 1);
        },
        tally.kinetic_before,
        tally.kinetic_after,
        tally.mass,
        tally.momentum
    );
  });
  return tally;
}

}  // namespace barreno
