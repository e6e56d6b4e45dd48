// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/dormancy.hpp"
#include "state/particles.hpp"

namespace barreno {

/// No row comes nearer to its cell's mean by more of the difference in a step.
inline constexpr double most_relaxed = 0.2;
/// |ln(V / V_ref)| beyond which a row has torn or is in a strong shock: it is left alone, and its
/// neighbours do not see it.
inline constexpr double intact_volume = 0.25;

/// Particles of one cell that flow come nearer to the cell's volume ratio J, by parts of dt L that
/// change volumes alone. The grid sees the sum of their forces only, so pressures that alternate
/// from particle to particle would stay in a material that has flown. docs/method.md 13
///
///   dt L_ii <- dt L_ii - min(0.2, rate |dev(dt D)|) (ln J_p - mean of ln J) / dimensions
///
/// The mean is weighted by volumes; the hoop strain of axisymmetry belongs to the radius and stays.
/// @param rate                 MaterialSpec::volume_relaxation, per norm of shear strain [-]
/// @param reference_density    of the material [mass/length^3]
/// @param[in,out] particles    `increment` is dt L
void relax_volumes(
    const Grid& grid,
    const Dormancy& dormancy,
    double rate,
    double reference_density,
    const Particles& particles
);

}  // namespace barreno
