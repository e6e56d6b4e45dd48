// SPDX-License-Identifier: BSD-3-Clause
#include "step/transfer/accelerate_particles.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "base/row_sum.hpp"
#include "shape/kinematics.hpp"
#include "state/row_frames.hpp"

namespace barreno {

namespace {

/// The particles of a chunk are processed together: their loop vectorises, and so do the sums over
/// them.
template <class M>
struct AccelerateParticles {
  FieldView velocity, grid_motion, mass;
  TallyScales scales;
  RowFrames frames;
  GridShare grid_share;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int count, ParticleTally& tally) const {
    double momentum[rows_per_chunk];
    double gain[rows_per_chunk];
    double kinetic[rows_per_chunk];
    BARRENO_IVDEP
    for (int k = 0; k < count; ++k) {
      constexpr int dimensions = M::dimensions;
      const int p = begin + k;
      const double m = mass(p, 0);
      const double share = grid_share(frames.dt(p));
      double old_square = 0.0;
      double new_square = 0.0;
      for (int d = 0; d < dimensions; ++d) {
        const double v = velocity(p, d);
        const double w =
            (1.0 - share) * (v + grid_motion(p, dimensions + d)) + share * grid_motion(p, d);
        old_square += v * v;
        new_square += w * w;
        if (d == 1) momentum[k] = m * w;
        velocity(p, d) = w;
      }
      gain[k] = 0.5 * m * (new_square - old_square);
      kinetic[k] = 0.5 * m * new_square;
    }
    add_masses(begin, count, tally);
    add_chunk(gain, count, scales.energy, tally.gain);
    add_chunk(kinetic, count, scales.energy, tally.kinetic);
    add_chunk(momentum, count, scales.momentum, tally.momentum);
  }

  KOKKOS_INLINE_FUNCTION void add_masses(int begin, int count, ParticleTally& tally) const {
    double masses[rows_per_chunk];
    for (int k = 0; k < count; ++k) masses[k] = mass(begin + k, 0);
    add_chunk(masses, count, scales.mass, tally.mass);
  }
};

template <class Kernel>
ParticleTally accelerate_rows(const Kernel& kernel, Rows rows) {
  ParticleTally tally;
  launch_reduction(
      "accelerate_particles",
      range((rows.end - rows.begin + rows_per_chunk - 1) / rows_per_chunk),
      KOKKOS_LAMBDA(const int chunk, ParticleTally& part) {
        const int begin = rows.begin + chunk * rows_per_chunk;
        const int left = rows.end - begin;
        const int count = left < rows_per_chunk ? left : rows_per_chunk;
        if (rows.skips(begin))
          kernel.add_masses(begin, count, part);
        else
          kernel(begin, count, part);
      },
      TallyReducer<ParticleTally>(tally)
  );
  return tally;
}

/// Of the rows as they are.
struct TallyMomentum {
  FieldView velocity, mass;
  TallyScales scales;
  int dimensions, count;

  KOKKOS_INLINE_FUNCTION void operator()(int chunk, ParticleTally& tally) const {
    double masses[rows_per_chunk];
    double momentum[rows_per_chunk];
    double kinetic[rows_per_chunk];
    const int begin = chunk * rows_per_chunk;
    const int rows = count - begin < rows_per_chunk ? count - begin : rows_per_chunk;
    for (int k = 0; k < rows; ++k) {
      const int p = begin + k;
      double square = 0.0;
      for (int d = 0; d < dimensions; ++d) square += velocity(p, d) * velocity(p, d);
      masses[k] = mass(p, 0);
      momentum[k] = mass(p, 0) * velocity(p, 1);
      kinetic[k] = 0.5 * mass(p, 0) * square;
    }
    add_chunk(masses, rows, scales.mass, tally.mass);
    add_chunk(momentum, rows, scales.momentum, tally.momentum);
    add_chunk(kinetic, rows, scales.energy, tally.kinetic);
  }
};

}  // namespace

ParticleTally tally_momentum(const Particles& particles) {
  ParticleTally tally;
  launch_reduction(
      "tally_momentum",
      range((particles.count + rows_per_chunk - 1) / rows_per_chunk),
      TallyMomentum{
          particles.velocity.values,
          particles.mass.values,
          particles.tally_scales,
          particles.velocity.components,
          particles.count},
      TallyReducer<ParticleTally>(tally)
  );
  return tally;
}

ParticleTally accelerate_particles(
    const StepSpec& step, const Grid& grid, Rows rows, Particles& particles
) {
  const Region region("accelerate_particles");
  return visit_mode(grid.mode, [&](auto mode) {
    return accelerate_rows(
        AccelerateParticles<decltype(mode)>{
            particles.velocity.values,
            particles.grid_motion.values,
            particles.mass.values,
            particles.tally_scales,
            RowFrames(grid, particles),
            GridShare(step)},
        rows
    );
  });
}

}  // namespace barreno
