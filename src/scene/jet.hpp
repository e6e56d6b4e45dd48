// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace barreno {

/// What a jet table launches; of the full circle in axisymmetry, per unit thickness in plane
/// strain.
struct JetTotals {
  double mass = 0.0;      ///< [mass]
  double momentum = 0.0;  ///< along the jet's direction, positive [mass length/time]
  double energy = 0.0;    ///< kinetic [mass length^2/time^2]
};

/// Cross-section of a slug: a disk, in three dimensions the part of it on the grid's side of planes
/// x = 0 and z = 0, in plane strain the part of its width that the grid holds.
double cross_section(const JetSlug& slug, const GridSpec& grid);

JetTotals jet_totals(const JetSpec& jet, const GridSpec& grid);

/// A discrete jet from a jet table's rows {time, velocity, radius, length, density}: a density
/// below the material's means void, which becomes length, so that every slug has the material's
/// density and its own mass.
/// @param[out] problem  empty, or what is wrong with the table, for a sentence
std::vector<JetSlug> discrete_slugs(
    const std::vector<std::vector<double>>& rows, double material_density, std::string& problem
);

}  // namespace barreno
