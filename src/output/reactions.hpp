// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

#include <string>
#include <vector>

namespace barreno {

/// What the other bodies have given to the rigid bodies of a scene since t = 0, axis by axis of
/// each in the order of the deck [momentum]. In axisymmetry the axial part of the full circle
/// (across the axis there is no resultant), in plane strain per unit thickness, in three dimensions
/// of the part inside the grid. The same bits on every rank and any number of them. Collective.
std::vector<double> reaction_impulses(const State& state);

/// Columns of history.csv for them: NAME_force_AXIS and NAME_impulse_AXIS.
std::vector<std::string> reaction_columns(const Scene& scene);

/// Their values at a row: mean forces over the time since the row before, and the impulses.
/// @param elapsed  since the row before; 0 at the first, where there is no force yet [time]
/// @param before   impulses at the row before
std::vector<double> reaction_values(
    const std::vector<double>& impulses, const std::vector<double>& before, double elapsed
);

}  // namespace barreno
