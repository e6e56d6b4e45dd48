// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"
#include "state/state.hpp"

#include <vector>

namespace barreno {

/// Kinematic anomalies: single particles whose motion is that of no continuum, such as those at the
/// edges of the slugs of a discrete jet. Beyond these bounds they are counted, of every run.

/// Largest singular value of F of a particle that counts as stretched [-].
inline constexpr double anomalous_stretch = 20.0;
/// Speed of a particle that counts as ejected, over the largest speed that was put in [-].
inline constexpr double anomalous_speed = 1.2;

/// Those of one material now. Particles that are gone are in removed_particles, by their cause.
struct Anomalies {
  double stretched = 0.0;        ///< beyond anomalous_stretch
  double ejected = 0.0;          ///< faster than anomalous_speed allows
  double clipped = 0.0;          ///< domains cut at Largest Domain, of shapes that deform
  double largest_stretch = 0.0;  ///< [-]
  double largest_speed = 0.0;    ///< [length/time]
};

KOKKOS_INLINE_FUNCTION void add(const Anomalies& part, Anomalies& sum) {
  sum.stretched += part.stretched;
  sum.ejected += part.ejected;
  sum.clipped += part.clipped;
  sum.largest_stretch =
      part.largest_stretch > sum.largest_stretch ? part.largest_stretch : sum.largest_stretch;
  sum.largest_speed =
      part.largest_speed > sum.largest_speed ? part.largest_speed : sum.largest_speed;
}

/// The particle with the largest value of all; of equal ones the first.
struct ExtremeParticle {
  ParticleId id = -1;  ///< -1: there is none
  int material = -1;
  double value = 0.0;
  Vector position{};
};
struct Extremes {
  ExtremeParticle hottest;         ///< of the materials that know their temperature
  ExtremeParticle most_stretched;  ///< by the largest singular value of F
};

/// Held debris and rigid bodies are left out. Collective, the same on every rank.
Extremes find_extremes(const Scene& scene, const State& state);

/// By material; held debris is left out. Collective, the same on every rank.
std::vector<Anomalies> count_anomalies(const Scene& scene, const State& state);

}  // namespace barreno
