// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drive/driven_state.hpp"

#include <barreno/models.hpp>
#include <string>
#include <vector>

namespace barreno {

/// Meridians and octahedral sections of the yield surface, for a picture of a path: CSV with the
/// columns
///   state       initial (first row) or current
///   section     compression (theta = 60 degrees), extension (0) or octahedral
///   time        [s], of the state
///   lode_angle  theta [degrees]
///   I1          of the stress that the surface bounds [Pa]
///   sqrt_J2     [Pa]
/// Current meridians are those of the last row. Octahedral sections are taken where sqrt(J2) is
/// largest: at that I1, the initial one and that of this row. A surface without a section there has
/// no such rows; extension stands only where the strength depends on the angle.
///
/// @return an empty text for a material without a yield surface
std::string yield_table(const Material& material, const std::vector<DrivenState>& states);

/// sqrt(J2) of a stress [Pa].
double shear_of(const Sym3& stress);

}  // namespace barreno
