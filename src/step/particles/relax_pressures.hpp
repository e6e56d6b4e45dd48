// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/dormancy.hpp"
#include "state/particles.hpp"

namespace barreno {

/// Density over that of the metal without pressure, beyond which a row is too dense: few shocks of
/// a jet reach it.
inline constexpr double too_dense = 1.5;
/// Rate per norm of shear strain, the largest part in a step, and the largest change of ln V of a
/// row in a step.
inline constexpr double pressure_relaxation = 30.0;
inline constexpr double most_equalised = 0.2;
inline constexpr double largest_volume_change = 0.05;

/// Particles of a cell of which one is too dense come nearer to one pressure, by parts of dt L that
/// change volumes alone and leave the cell its volume. A particle that is small beside its cell
/// hardly resists the motion of the nodes, so that its pressure could rise without bound while
/// voids beside it stay open. docs/method.md 13
///
///   dt L_ii <- dt L_ii + f (p_p - p)/(M_p d),   p = sum (V_q p_q/M_q) / sum (V_q/M_q) over the
///   cell f = min(0.2, 30 mean of |dev(dt D)|), and no more than changes a volume by 5 %
///
/// M is the longitudinal modulus, next to none of a row with an open void: voids close first.
/// @param reference_density    of the material [mass/length^3]
/// @param[in,out] particles    `increment` is dt L
void relax_pressures(
    const Grid& grid, const Dormancy& dormancy, double reference_density, const Particles& particles
);

}  // namespace barreno
