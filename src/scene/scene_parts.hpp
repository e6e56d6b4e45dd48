// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/deck.hpp"
#include "scene/scene.hpp"

#include <string>

namespace barreno {

/// The parts of build_scene. Each reads its sections of the deck and adds to the scene; a later
/// part may use what an earlier one built. All throw DeckError.

void add_bodies(const Deck& deck, Scene& scene);
/// Levels of the grid's tiles; after check_size, which says whether the box can be indexed, after
/// the jet, whose path can be refined, and after what may not work across levels.
void add_refinement(const Deck& deck, Scene& scene);
/// After all else: refuses what does not work across levels.
void check_refinement(const Deck& deck, const Scene& scene);
/// Refuses several parts of a step where all tiles take one, or leaves them out where a fidelity
/// chose them.
void settle_subcycles(const Deck& deck, Scene& scene);
void add_conditions(const Deck& deck, Scene& scene);
void add_loads(const Deck& deck, Scene& scene);
void add_confinement(const Deck& deck, Scene& scene);
/// After the confinement: refuses fluid under a pressure that its rock cannot start with.
void check_pore_pressures(const Deck& deck, const Scene& scene);
void add_jet(const Deck& deck, Scene& scene);
/// When the run ends; after the jet.
void add_end(const Deck& deck, Scene& scene);
/// Refuses voids that their material cannot have.
void check_expansions(const Deck& deck, const Scene& scene);
/// After the bodies and the jet: refuses an explosive that nothing lights.
void add_detonation(const Deck& deck, Scene& scene);
void add_body_force(const Deck& deck, Scene& scene);
/// After all else: densities and gravity are scaled.
void add_quasi_static(const Deck& deck, Scene& scene);
void add_contacts(const Deck& deck, Scene& scene);
void add_pore_flow(const Deck& deck, Scene& scene);

/// Refuses a grid or particles that are too many for memory or for what counts them, before
/// anything is allocated; the grid needs no bodies for it.
void check_size(const Deck& deck, const Scene& scene);
/// Refuses a box with more tiles than can be refined, before their levels are looked for.
void check_refined_size(const Deck& deck, const GridSpec& grid);
/// After all else: refuses speeds that nothing has, and masses and energies that the balances
/// cannot hold.
void check_magnitudes(const Deck& deck, const Scene& scene);

/// Motion of the body of that name, if it is prescribed to be rigid.
MotionSpec read_motion(const Deck& deck, const std::string& body, Mode mode);
/// A rigid body has a material of its own, and nothing presses it.
void check_rigid_bodies(const Deck& deck, const Scene& scene);

/// A number by a printf format, for sentences.
std::string text_of(const char* format, double x);

/// The shape that a list of Bodies or Shapes says, with its parts; every list of Shapes is one.
Shape read_shape(const Deck& deck, const std::string& path, Mode mode);
void check_shapes(const Deck& deck, Mode mode);

/// Bodies have something to fill, are not thinner than a particle, and lie apart. Fills their
/// lattices, so memory must have been checked.
void check_bodies(const Deck& deck, const Scene& scene);
/// Refuse bodies that fill the same place. Of n bodies that are scattered it looks at about n
/// pairs.
void check_overlaps(const Deck& deck, const Scene& scene);

/// Index of the body of that name, which the parameter at `path` says.
int body_named(
    const Deck& deck, const Scene& scene, const std::string& path, const std::string& name
);

/// A load of the scene so far acts on that face or surface of the body.
bool is_loaded(const Scene& scene, int body, Face face);
bool is_loaded(const Scene& scene, int body, BallSurface surface);

}  // namespace barreno
