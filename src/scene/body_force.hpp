// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/numbers.hpp"
#include "scene/scene.hpp"

#include <Kokkos_Macros.hpp>

#include <cmath>

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

namespace detail {

KOKKOS_INLINE_FUNCTION double wave_speed(const BodyForceSpec& spec) {
  return std::sqrt(spec.young / spec.density);
}
/// A sin(pi c t) and its rate at t = 0.
KOKKOS_INLINE_FUNCTION double swing(const BodyForceSpec& spec, double time) {
  return spec.amplitude * std::sin(pi * wave_speed(spec) * time);
}
KOKKOS_INLINE_FUNCTION double start_rate(const BodyForceSpec& spec) {
  return spec.amplitude * pi * wave_speed(spec);
}

KOKKOS_INLINE_FUNCTION double phase_sign(int axis) {
  return axis == 1 ? -1.0 : 1.0;
}

/// u, F and u'' of one axis of the axis-aligned displacement.
struct AxisMotion {
  double u, stretch, curvature;
};
KOKKOS_INLINE_FUNCTION AxisMotion axis_motion(double s, double x) {
  const double u = s * std::sin(pi * x);
  return {u, 1.0 + s * pi * std::cos(pi * x), -pi * pi * u};
}

/// -(pi c)^2 u - u'' [(lambda (1 - k) + mu) / F^2 + mu] / rho0, k = ln J.
KOKKOS_INLINE_FUNCTION double axial_force(
    const BodyForceSpec& spec, const AxisMotion& a, double k
) {
  const double slope =
      (spec.lambda * (1.0 - k) + spec.shear) / (a.stretch * a.stretch) + spec.shear;
  const double rate = pi * wave_speed(spec);
  return -rate * rate * a.u - a.curvature * slope / spec.density;
}

KOKKOS_INLINE_FUNCTION Vector
aligned_force(const BodyForceSpec& spec, const Vector& x, double time) {
  AxisMotion motion[3];
  double k = 0.0;
  for (int i = 0; i < spec.dimensions; ++i) {
    motion[i] = axis_motion(phase_sign(i) * swing(spec, time), x[static_cast<std::size_t>(i)]);
    k += std::log(motion[i].stretch);
  }
  Vector force{};
  for (int i = 0; i < spec.dimensions; ++i)
    force[static_cast<std::size_t>(i)] = axial_force(spec, motion[i], k);
  return force;
}

KOKKOS_INLINE_FUNCTION Vector
axisymmetric_force(const BodyForceSpec& spec, const Vector& x, double time) {
  const double radius = x[0];
  const AxisMotion r = axis_motion(phase_sign(0) * swing(spec, time), radius);
  const AxisMotion z = axis_motion(phase_sign(1) * swing(spec, time), x[1]);
  const double hoop = 1.0 + r.u / radius;
  const double hoop_slope = (r.stretch - 1.0) / radius - r.u / (radius * radius);
  const double k = std::log(r.stretch * hoop * z.stretch);
  const auto stress = [&](double f) { return spec.lambda * k / f + spec.shear * (f - 1.0 / f); };
  const double hoop_part =
      spec.lambda * hoop_slope / (r.stretch * hoop) + (stress(r.stretch) - stress(hoop)) / radius;
  return {axial_force(spec, r, k) - hoop_part / spec.density, axial_force(spec, z, k), 0.0};
}

/// Components along the radius and across it, of a point of the plane at `angle`.
KOKKOS_INLINE_FUNCTION Vector from_polar(double radial, double across, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * radial - s * across, s * radial + c * across, 0.0};
}

struct Polar {
  double radius, angle;
};
KOKKOS_INLINE_FUNCTION Polar polar(const BodyForceSpec& spec, const Vector& x) {
  const double dx = x[0] - spec.centre[0];
  const double dy = x[1] - spec.centre[1];
  return {std::hypot(dx, dy), std::atan2(dy, dx)};
}

KOKKOS_INLINE_FUNCTION double vortex_profile(double r) {
  const double root = (4.0 * r - 5.0) * (4.0 * r - 3.0);
  return root * root;
}

KOKKOS_INLINE_FUNCTION Vector
vortex_force(const BodyForceSpec& spec, const Vector& x, double time) {
  const auto [r, angle] = polar(spec, x);
  const double s = swing(spec, time);
  const double h = vortex_profile(r);
  const double slope = 64.0 * (r - 1.0) * (4.0 * r - 5.0) * (4.0 * r - 3.0);
  const double rate = pi * wave_speed(spec);
  const double spin = start_rate(spec) * std::cos(rate * time) * h;
  const double stiffness = spec.shear / spec.density;
  const double radial = -r * spin * spin + stiffness * r * s * s * slope * slope;
  const double cubic = 96.0 * r * r * r - 240.0 * r * r + 188.0 * r - 45.0;
  const double across = -s * (r * rate * rate * h + stiffness * 64.0 * cubic);
  return from_polar(radial, across, angle + s * h);
}

/// g, g' and g'' of the expanding ring.
struct RingProfile {
  double g, slope, curvature;
};
KOKKOS_INLINE_FUNCTION RingProfile ring_profile(const BodyForceSpec& spec, double r) {
  const double inner = spec.inner_radius;
  const double outer = spec.outer_radius;
  const double scale = 1.0 / (outer * (outer - 3.0 * inner));
  const double c1 = -6.0 * inner * scale;
  const double c2 = 3.0 * (outer + inner) * scale / outer;
  const double c3 = -2.0 * scale / outer;
  return {c1 + r * (c2 + r * c3), c2 + 2.0 * r * c3, 2.0 * c3};
}

KOKKOS_INLINE_FUNCTION Vector ring_force(const BodyForceSpec& spec, const Vector& x, double time) {
  const auto [r, angle] = polar(spec, x);
  const RingProfile g = ring_profile(spec, r);
  const double s = swing(spec, time);
  const double hoop = 1.0 + s * g.g;
  const double radial = hoop + r * s * g.slope;
  const double radial_slope = 2.0 * s * g.slope + r * s * g.curvature;
  const auto stress = [&](double f) { return spec.shear * (f - 1.0 / f); };
  const double divergence = spec.shear * radial_slope * (1.0 + 1.0 / (radial * radial)) +
                            (stress(radial) - stress(hoop)) / r;
  const double rate = pi * wave_speed(spec);
  return from_polar(-rate * rate * s * g.g * r - divergence / spec.density, 0.0, angle);
}

}  // namespace detail

/// Force per mass on the particle that was at X [acceleration].
///
/// Out of line, so that it is rounded alike in all kernels: inlined, the compiler fuses its
/// products into sums in an order that depends on what is around it.
[[gnu::noinline]] KOKKOS_FUNCTION inline Vector body_force(
    const BodyForceSpec& spec, const Vector& reference, double time
) {
  switch (spec.kind) {
    case BodyForceKind::gravity:
      return spec.acceleration;
    case BodyForceKind::axis_aligned:
      return spec.axisymmetric ? detail::axisymmetric_force(spec, reference, time)
                               : detail::aligned_force(spec, reference, time);
    case BodyForceKind::vortex:
      return detail::vortex_force(spec, reference, time);
    case BodyForceKind::ring:
      return detail::ring_force(spec, reference, time);
    case BodyForceKind::none:
      break;
  }
  return {};
}

/// Velocity of that particle at t = 0 [velocity].
inline Vector prescribed_start_velocity(const BodyForceSpec& spec, const Vector& reference) {
  const double rate = detail::start_rate(spec);
  Vector velocity{};
  if (spec.kind == BodyForceKind::axis_aligned) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(spec.dimensions); ++i)
      velocity[i] = detail::phase_sign(static_cast<int>(i)) * rate * std::sin(pi * reference[i]);
  } else if (spec.kind == BodyForceKind::vortex) {
    const auto [r, angle] = detail::polar(spec, reference);
    velocity = detail::from_polar(0.0, r * rate * detail::vortex_profile(r), angle);
  } else if (spec.kind == BodyForceKind::ring) {
    const auto [r, angle] = detail::polar(spec, reference);
    velocity = detail::from_polar(rate * detail::ring_profile(spec, r).g * r, 0.0, angle);
  }
  return velocity;
}

/// Whether the force depends on where the particle was at the start.
KOKKOS_INLINE_FUNCTION bool is_manufactured(const BodyForceSpec& spec) {
  return spec.kind != BodyForceKind::none && spec.kind != BodyForceKind::gravity;
}

}  // namespace barreno
