// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/reproducible_sum.hpp"
#include "base/rows.hpp"
#include "grid/grid.hpp"
#include "state/particles.hpp"

#include <cmath>
#include <limits>

namespace barreno {

/// Work of one stress update and its bounds for the next step; sums over this rank's particles
/// of one set.
struct StressTally {
  ReproducibleSum elastic, plastic, viscous;  ///< of the materials [energy]
  ReproducibleSum explosive;  ///< what explosives gave, which enter none of these [energy]
  ReproducibleSum
      stress_work;  ///< trapezoid of (sigma - q I) : d_eps V, the particles' view of the same work
  double stable_step = std::numeric_limits<double>::infinity();  ///< smallest of the set [time]
  double failures = 0.0;                                         ///< points whose update failed
  ParticleId first_failed = -1;                                  ///< smallest id among them
};

/// Add one part of a set or of a scene to the sum of the others.
KOKKOS_INLINE_FUNCTION void add(const StressTally& part, StressTally& sum) {
  sum.elastic += part.elastic;
  sum.plastic += part.plastic;
  sum.viscous += part.viscous;
  sum.explosive += part.explosive;
  sum.stress_work += part.stress_work;
  sum.stable_step = std::fmin(sum.stable_step, part.stable_step);
  sum.failures += part.failures;
  if (part.first_failed >= 0 && (sum.first_failed < 0 || part.first_failed < sum.first_failed))
    sum.first_failed = part.first_failed;
}

/// Timer label of a material's update; forms of a model are told apart.
const char* stress_label(const Material& material);

/// Stress, history and artificial viscosity of one set, by its own material. docs/method.md (2.9)
///
///   q = rho (A1 c h |tr D| + A2 h^2 (tr D)^2) in compression, else 0
///
/// A failed point keeps stress and history; a point that has expanded beyond the step's bound is
/// rubble that no continuum describes, and counts as failed. The material's particle policy marks
/// it for removal or holds it stress-free.
///
/// An explosive burns first, and has no viscosity where nothing has burnt.
///
/// @param end  of the step [time]
/// @pre particles.increment holds the strain increment and the old volume (update_deformation)
StressTally update_stress(
    const MaterialSpec& spec,
    const StepSpec& step,
    const Grid& grid,
    double end,
    Rows rows,
    Particles& particles
);

}  // namespace barreno
