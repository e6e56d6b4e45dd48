// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/rows.hpp"
#include "shape/generator.hpp"
#include "state/particles.hpp"

namespace barreno {

/// Deformation gradient and the strain increment that the materials see. docs/method.md (2.8)
///
///   F <- exp(A) F,   V <- det(exp(A)) V,   d_eps = R_m^T sym(A) R_m,   R_m half-way between the
///   rotations of old and new F, A the generator of the step (shape/generator.hpp)
///
/// @pre  particles.increment holds dt L
/// @post particles.increment holds the unrotated strain increment xx yy zz xy and the old volume
void update_deformation(Mode mode, Rows rows, Gradient gradient, Particles& particles);

}  // namespace barreno
