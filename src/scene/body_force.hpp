// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

namespace barreno {

/// Motions that are prescribed by a force per mass at every particle, to measure the error of the
/// code: x(X, t) is chosen, F and the stress of a neo-Hookean material (lambda, mu) follow, and
///
///   b = d2x/dt2 - Div P / rho0
///
/// All start undeformed. c = sqrt(E / rho0), s = A sin(pi c t). Constants carry metres.
///
/// Axis-aligned displacement on the unit box, between smooth walls:
///   u_i = q_i s sin(pi X_i), q = +1 -1 +1;  F_i = 1 + du_i/dX_i,  k = ln F_1 F_2 F_3
///   b_i = pi^2 u_i [mu / rho0 - c^2 - (lambda (k - 1) - mu) / (rho0 F_i^2)]
/// in axisymmetry F_2 = 1 + u_r / R is the hoop stretch, P_i = lambda k / F_i + mu (F_i - 1 / F_i),
///   b_r = -(pi c)^2 u_r - [u_r'' ((lambda (1 - k) + mu) / F_1^2 + mu) + lambda F_2' / (F_1 F_2)
///         + (P_1 - P_2) / R] / rho0,   b_z as in the plane.
///
/// Generalized vortex of a disk 0.75 < R < 1.25, free surfaces, pure shear: rotation by
///   s h(R),  h = (4 R - 5)^2 (4 R - 3)^2.
///
/// Expanding ring of a material without lateral strain (lambda = 0, mu = E / 2), free surfaces:
///   x = (1 + s g(R)) X,  g = c1 + c2 R + c3 R^2,  c1 = -6 r_i / (r_o (r_o - 3 r_i)),
///   c2 = 3 (r_o + r_i) / (r_o^2 (r_o - 3 r_i)),  c3 = -2 / (r_o^2 (r_o - 3 r_i)).
/// @par Source  P. Wallstedt, J. Guilkey, J. Comput. Phys. 227 (2008) 9628-9642 (axis-aligned,
///   ring); K. Kamojjala et al., Engng Comput. 31 (2015) 209-226 (vortex); the axisymmetric form is
///   derived here and in verification/oracles/manufactured.py, where momentum is checked.

/// Force per mass on the particle that was at X [acceleration].
Vector body_force(const BodyForceSpec& spec, const Vector& reference, double time);

/// Velocity of that particle at t = 0 [velocity].
Vector prescribed_start_velocity(const BodyForceSpec& spec, const Vector& reference);

/// Whether the force depends on where the particle was at the start.
inline bool is_manufactured(const BodyForceSpec& spec) {
  return spec.kind != BodyForceKind::none && spec.kind != BodyForceKind::gravity;
}

}  // namespace barreno
