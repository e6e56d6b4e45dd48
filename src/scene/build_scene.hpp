// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/deck.hpp"
#include "scene/scene.hpp"

namespace barreno {

/// The scene that a deck asks for, with the rules that cross sections checked: what is named
/// exists, bodies lie in the grid and apart, the jet is launched in free space, the run fits into
/// memory.
/// @throws DeckError  with one sentence
Scene build_scene(const Deck& deck);

/// Bytes that grid and particles of a scene need, over all ranks; nothing is allocated for it.
double memory_estimate(const Scene& scene);

/// Particles of the bodies and of the whole jet.
double particle_estimate(const Scene& scene);

/// sqrt(c t) over the run, c = k M / viscosity of the fastest rock as it starts: how far pore
/// pressure diffuses [length].
double drained_length(const Scene& scene);

}  // namespace barreno
