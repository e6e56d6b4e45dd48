// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

namespace barreno {

/// Critical number c dt / h of a particle of a material that is alone in its cells, less a margin.
///
/// With stress last such a particle's stress strains it at once by sigma' = (1 - w) sigma,
/// w = (c dt / h)^2 k, k = sum_I h^2 g_I^2 / S_I, and none of it is left in its velocity, which all
/// of its nodes share: not an oscillator that is stable to w = 4 but a decay that is to w = 2
/// (docs/method.md 4). Bodies of many particles are between the two. All d strains at once are
/// stiffer by 1 + (d - 1) lambda / M, M = K + 4G/3 = lambda + 2G, in the state of the start, which
/// is what flies alone. In axisymmetry the hoop strain is the third.
///
/// @return infinite if the deck does not ask for it, and for steps that leave the particles'
/// velocities in the strain (modified stress last, stress first, APIC)
double isolated_courant(const Scene& scene, int material);
/// The same of a material whose smallest particle is another.
/// @param half_size  of that particle [cells]
double isolated_courant(const Scene& scene, int material, double half_size);

}  // namespace barreno
