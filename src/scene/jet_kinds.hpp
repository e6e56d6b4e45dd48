// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace barreno {

/// The kinds of a jet, made from one table of slugs: all have the table's mass, momentum and
/// kinetic energy, slug by slug. docs/jets.md

/// The rows of a table with the lengths at which neighbours touch when they cross the launch plane:
/// velocity times touching_duration() (deck/touching_duration.hpp). Mass is kept: the density is
/// the mean one. Rows that touch, and a single one, stay as they are.
std::vector<JetSlug> touching_slugs(const std::vector<JetSlug>& table);

/// The slugs that are launched.
///
///   discrete    full density, length * density / material's: voids become gaps between slugs
///   thinned     touching, full density: the radius shrinks by sqrt(mean over full density), in
///               plane strain the half-width by that ratio
///   continuous  touching, mean density: voids are an expansion strain
///
/// @pre  problem_of_kind() finds none
std::vector<JetSlug> slugs_of_kind(
    const std::vector<JetSlug>& table, JetKind kind, Mode mode, double material_density
);

/// Why a table cannot make a jet of that kind, for a sentence; or nothing.
std::string problem_of_kind(
    const std::vector<JetSlug>& table, JetKind kind, double material_density
);

}  // namespace barreno
