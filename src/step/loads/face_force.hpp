// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/numbers.hpp"
#include "shape/kinematics.hpp"
#include "state/load_table.hpp"

#include <cmath>

namespace barreno {

/// The deformed face as a vector outwards: J F^-T N A, N and A of the undeformed particle (Nanson).
///
/// In axisymmetry the radius at the start follows from the initial volume, which is that of the
/// full ring.
template <class M>
KOKKOS_INLINE_FUNCTION Vector face_area(const Particles& particles, int p, int face) {
  const int axis = face / 2;
  const double side = face % 2 == 0 ? -1.0 : 1.0;
  const auto f = load_tensor<M>(particles.deformation_gradient.values, p);
  double area = particles.volume(p) / determinant(f) / (2.0 * particles.half_size(p, axis));
  if (M::hoop && axis == 0)
    area += side * two_pi * particles.half_size(p, 0) * 2.0 * particles.half_size(p, 1);
  const double scale = area * side;
  const auto c = cofactors(f);
  if constexpr (M::dimensions == 3) {
    if (axis == 0) return {scale * c.xx, scale * c.yx, scale * c.zx};
    if (axis == 1) return {scale * c.xy, scale * c.yy, scale * c.zy};
    return {scale * c.xz, scale * c.yz, scale * c.zz};
  } else {
    if (axis == 0) return {scale * c.xx, scale * c.yx};
    return {scale * c.xy, scale * c.yy};
  }
}

KOKKOS_INLINE_FUNCTION double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// rho c_p |A| of a face of a particle: its impedance against plane waves that come straight
/// [mass/time].
KOKKOS_INLINE_FUNCTION double face_impedance(
    const Particles& particles, int p, const Vector& area
) {
  const double density = particles.mass(p) / particles.volume(p);
  return std::sqrt(density * particles.longitudinal_modulus(p) * dot(area, area));
}

/// -(rho c_p v_n n + rho c_s v_t) |A|: what a plane wave that goes on would do to the face [force].
/// Source: J. Lysmer, R. Kuhlemeyer, J. Eng. Mech. Div. ASCE 95 (1969).
///
/// Out of line, so that it is rounded before a pressure is added: inlined, the compiler fuses its
/// product into that sum in some kernels and not in others.
/// @pre particles.shear_modulus
[[gnu::noinline]] KOKKOS_FUNCTION inline Vector dashpot_force(
    const Particles& particles, int p, const Vector& area
) {
  const double along = face_impedance(particles, p, area);
  const double slower = std::sqrt(particles.shear_modulus(p) / particles.longitudinal_modulus(p));
  Vector v{};
  for (int d = 0; d < particles.velocity.components; ++d)
    v[static_cast<std::size_t>(d)] = particles.velocity(p, d);
  const double normal = (1.0 - slower) * dot(v, area) / dot(area, area);
  Vector force{};
  for (std::size_t d = 0; d < 3; ++d) force[d] = -along * (slower * v[d] + normal * area[d]);
  return force;
}

/// Force of a load on a face of a particle.
template <class M>
KOKKOS_INLINE_FUNCTION Vector
face_force(const AppliedLoad& load, const Particles& particles, int p, int face) {
  const Vector area = face_area<M>(particles, p, face);
  Vector force = load.non_reflecting ? dashpot_force(particles, p, area) : Vector{};
  const double pressure = load.pressure;
  for (std::size_t d = 0; d < 3; ++d) force[d] -= pressure * area[d];
  return force;
}

}  // namespace barreno
