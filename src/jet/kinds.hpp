// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <vector>

namespace barreno {

/// How much of a table's jet is metal.
struct JetVoids {
  double filled = 1.0;        ///< solid over whole length
  double least_filled = 1.0;  ///< of the slug with most void
};
JetVoids jet_voids(const std::vector<JetSlug>& table, double material_density);

/// Hydrodynamic depth of a strengthless target, over that by the discrete jet of the same table:
/// sum of L sqrt(rho_dig / rho_full) over the slugs of the kind, over the length of the metal. With
/// alpha = full over mean density of a slug, its length counts alpha times if it is thinned and
/// sqrt(2 alpha - 1) times if it is continuous: behind the shock that closes the voids the jet has
/// the stagnation pressure rho w^2 (2 alpha - 1) / (2 alpha^2) at the relative speed w.
/// @par Source  Birkhoff, MacDougall, Pugh & Taylor, J. Appl. Phys. 19 (1948) 563 (steady
///              penetration); the momentum balance of that shock.
double hydrodynamic_depth(
    const std::vector<JetSlug>& table, JetKind kind, Mode mode, double material_density
);

/// Density that stands for a slug in u = v / (1 + sqrt(rho_target / rho_jet)): its own, or of a
/// continuous one rho_mean (2 - 1 / alpha).
double digging_density(JetKind kind, const JetSlug& slug, double material_density);

}  // namespace barreno
