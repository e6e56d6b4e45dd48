// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <Kokkos_Core.hpp>

#include <cmath>

namespace barreno {

/// Impulse on the first of two bodies at a node, its opposite on the second; and its part along the
/// surface.
template <unsigned D>
struct ContactImpulse {
  double total[D] = {}, tangential[D] = {};
};

/// Impulse that keeps two bodies at a node from moving into each other. docs/method.md 6
///
///   w = v_b - v_a,   W = min(0, w . n + max(gap, 0) / dt)
///   J = m W n + T,   T = m (w - (w . n) n), shortened to friction * m |W|
///
/// stick: T whole; frictionless: none. Bonded fields are made to move as one, J = m w.
///
/// @param mass       reduced mass m_a m_b / (m_a + m_b); that of the other where one is rigid
/// @param w          velocity of b less that of a
/// @param normal     from a to b, unit; zero: they do not touch (bonded ones do not need it)
/// @param gap_speed  max(gap, 0) / dt: how fast they may approach
template <unsigned D>
KOKKOS_INLINE_FUNCTION ContactImpulse<D> contact_impulse(
    ContactKind kind,
    double friction,
    double mass,
    const double (&w)[D],
    const double (&normal)[D],
    double gap_speed
) {
  constexpr int dimensions = D;
  ContactImpulse<D> out;
  if (kind == ContactKind::bonded) {
    for (int d = 0; d < dimensions; ++d) out.total[d] = mass * w[d];
    return out;
  }
  double along = 0.0;
  double squared = 0.0;
  for (int d = 0; d < dimensions; ++d) along += w[d] * normal[d];
  for (int d = 0; d < dimensions; ++d) squared += normal[d] * normal[d];
  const double closing = along + gap_speed;
  if (squared == 0.0 || closing >= 0.0) return out;
  double slip = 0.0;
  for (int d = 0; d < dimensions; ++d) {
    out.total[d] = mass * closing * normal[d];
    out.tangential[d] = w[d] - along * normal[d];
    slip += out.tangential[d] * out.tangential[d];
  }
  slip = std::sqrt(slip);
  double share = kind == ContactKind::stick ? 1.0 : 0.0;
  if (kind == ContactKind::friction && slip > 0.0)
    share = std::fmin(1.0, -friction * closing / slip);
  for (int d = 0; d < dimensions; ++d) {
    out.tangential[d] *= mass * share;
    out.total[d] += out.tangential[d];
  }
  return out;
}

}  // namespace barreno
