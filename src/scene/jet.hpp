// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/sections/refinement_section.hpp"
#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace barreno {

/// The grid as slugs are cut for it: all of its cells are as large as where they are launched.
GridSpec grid_of_jet(const GridSpec& grid, const JetSpec& jet);

/// The path of a jet, to 2.5 times the radius of its widest slug, with the level at which
/// JetSpec::cells_per_radius cells fit in the radius of its thinnest one; 0 if those of the grid
/// do. There are the jet, what is left of it and the wall of its channel.
RefinedRegion path_of_jet(const GridSpec& grid, const JetSpec& jet);

/// Of all slugs [length/time].
double fastest_velocity(const JetSpec& jet);

/// Velocity below which the metal of a jet no longer digs: that of the deck, or a tenth of its
/// fastest slug's, whose stagnation pressure is a hundredth of the fastest one's [length/time].
double cut_off_velocity(const Scene& scene);

/// Largest cells on the axis between the launch plane and the back of the last body: they decide
/// how well the jet is resolved [length].
double cell_size_of_path(const Scene& scene);

/// The rows {time, velocity, radius, length, density} of a jet table, checked. A density below the
/// material's means void; what becomes of it is the jet's kind (scene/jet_kinds.hpp).
/// @param[out] problem  empty, or what is wrong with the table, for a sentence
std::vector<JetSlug> table_slugs(
    const std::vector<std::vector<double>>& rows, double material_density, std::string& problem
);

}  // namespace barreno
