// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/id_ranges.hpp"
#include "state/state.hpp"

#include <string>
#include <vector>

namespace barreno {

/// Particles, and their mass without the scaled inertia of a quasi-static run.
struct CountedMass {
  double particles = 0.0;
  double mass = 0.0;  ///< [mass]
};

/// A body of the run that a deck continues, or its jet.
struct ContinuedBody {
  std::string name;      ///< on one line
  bool in_deck = false;  ///< the deck has a body of that name
  CountedMass taken;     ///< what the deck's body starts with
  CountedMass left;      ///< what the run ended with and no body of the deck has
};

/// What a run started with that continues another one (Continue in its deck). Its own checkpoints
/// keep this: the other run may be gone by then.
struct Continued {
  double time = 0.0;                  ///< of the other run, at its end [time]
  std::vector<ContinuedBody> bodies;  ///< of the other run, its jet last
  std::vector<IdRange> ids;           ///< of those of these bodies that the deck has
  /// Smallest half size of the particles of each material [length]; 0: it has none.
  std::vector<double> half_sizes;
  std::vector<double> radii_start;  ///< start_of_radii of the undeformed bodies
  bool on() const { return !bodies.empty(); }
};

/// Bounds the steps of a state by the smallest particles that were taken over, where they are
/// smaller than those that the scene would make.
void bound_steps(const Scene& scene, const Continued& continued, State& state);

}  // namespace barreno
