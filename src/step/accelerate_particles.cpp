// SPDX-License-Identifier: BSD-3-Clause
#include "step/accelerate_particles.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "shape/kinematics.hpp"

#include <algorithm>

namespace barreno {

namespace {

/// Particles of a run are taken together: their loop vectorises, the sums over them follow in
/// storage order.
template <class M>
struct AccelerateParticles {
  FieldView velocity, grid_motion, mass;
  double pic;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int count, ParticleTally& tally) const {
    double momentum[rows_per_run];
    double before[rows_per_run];
    double after[rows_per_run];
    BARRENO_IVDEP
    for (int k = 0; k < count; ++k) {
      constexpr int dimensions = M::dimensions;
      const int p = begin + k;
      const double m = mass(p, 0);
      double old_square = 0.0;
      double new_square = 0.0;
      for (int d = 0; d < dimensions; ++d) {
        const double v = velocity(p, d);
        const double w =
            (1.0 - pic) * (v + grid_motion(p, dimensions + d)) + pic * grid_motion(p, d);
        old_square += v * v;
        new_square += w * w;
        if (d == 1) momentum[k] = m * w;
        velocity(p, d) = w;
      }
      before[k] = 0.5 * m * old_square;
      after[k] = 0.5 * m * new_square;
    }
    add_masses(begin, count, tally);
    for (int k = 0; k < count; ++k) {
      tally.kinetic_before += before[k];
      tally.kinetic_after += after[k];
      tally.momentum += momentum[k];
    }
  }

  KOKKOS_INLINE_FUNCTION void add_masses(int begin, int count, ParticleTally& tally) const {
    for (int k = 0; k < count; ++k) tally.mass += mass(begin + k, 0);
  }
};

template <class Kernel>
ParticleTally accelerate_rows(const Kernel& kernel, Rows rows) {
  ParticleTally tally;
  launch_reduction(
      "accelerate_particles",
      range((rows.end - rows.begin + rows_per_run - 1) / rows_per_run),
      KOKKOS_LAMBDA(const int run, double& before, double& after, double& mass, double& momentum) {
        const int begin = rows.begin + run * rows_per_run;
        const int left = rows.end - begin;
        const int count = left < rows_per_run ? left : rows_per_run;
        ParticleTally part;
        if (rows.skips(begin))
          kernel.add_masses(begin, count, part);
        else
          kernel(begin, count, part);
        before += part.kinetic_before;
        after += part.kinetic_after;
        mass += part.mass;
        momentum += part.momentum;
      },
      tally.kinetic_before,
      tally.kinetic_after,
      tally.mass,
      tally.momentum
  );
  return tally;
}

}  // namespace

double grid_share(const StepSpec& step, double dt) {
  const double damped = std::min(1.0, step.damping * dt);
  return step.pic_fraction + (1.0 - step.pic_fraction) * damped;
}

ParticleTally accelerate_particles(const Scene& scene, double dt, Rows rows, Particles& particles) {
  const Region region("accelerate_particles");
  return visit_mode(scene.grid.mode, [&](auto mode) {
    return accelerate_rows(
        AccelerateParticles<decltype(mode)>{
            particles.velocity.values,
            particles.grid_motion.values,
            particles.mass.values,
            grid_share(scene.step, dt)},
        rows
    );
  });
}

}  // namespace barreno
