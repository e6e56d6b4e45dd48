// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

namespace barreno {

/// Without shear stress, and cavitates (barreno/models/liquid.hpp): depths and holes of a jet are
/// those in other materials.
bool is_liquid(const MaterialSpec& material);

/// Pressure at the start of bodies that nothing confines, the Initial Pressure of a liquid; 0 of
/// others [stress].
double own_pressure(const MaterialSpec& material);

}  // namespace barreno
