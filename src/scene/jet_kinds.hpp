// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace barreno {

/// The kinds of a jet, made from one table of slugs: all have the table's mass, momentum and
/// kinetic energy, slug by slug. docs/jets.md

/// The rows of a table with the lengths at which neighbours touch when they cross the launch plane:
/// velocity times duration, from half-way between row i - 1 and i to half-way between i and i + 1;
/// the first and the last last as long as the interval next to them. Mass is kept: the density is
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

/// What the kinds of a table differ in.
struct JetVoids {
  double filled = 1.0;            ///< solid over whole length
  double least_filled = 1.0;      ///< of the slug with most void
  double thinned_depth = 1.0;     ///< hydrodynamic depth over that of the discrete jet
  double continuous_depth = 1.0;  ///< the same
};
/// Hydrodynamic depths of a strengthless target by jets of one mass, momentum and energy. With
/// alpha = full over mean density of a slug, its length counts alpha times if it is thinned and
/// sqrt(2 alpha - 1) times if it is continuous: behind the shock that closes the voids the jet has
/// the stagnation pressure rho w^2 (2 alpha - 1) / (2 alpha^2) at the relative speed w.
/// @par Source  Birkhoff, MacDougall, Pugh & Taylor, J. Appl. Phys. 19 (1948) 563 (steady
///              penetration); the momentum balance of that shock.
JetVoids jet_voids(const std::vector<JetSlug>& table, double material_density);

/// Density that stands for a slug in u = v / (1 + sqrt(rho_target / rho_jet)): its own, or of a
/// continuous one rho_mean (2 - 1 / alpha).
double digging_density(JetKind kind, const JetSlug& slug, double material_density);

}  // namespace barreno
