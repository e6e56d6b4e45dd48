// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

namespace barreno {

/// Thickness of a body's wall in cells, by the mean distance of its particles from its surface,
/// which in a wall of even thickness is a quarter of it. Of walls of two cells or less: beyond that
/// it is too small, and at most 4.
double cells_of_wall(const Scene& scene, const BodySpec& body);

/// A warning that a liner or a case, a body beside an explosive, is thinner than two cells; empty
/// if none is.
std::string wall_note(const Scene& scene);

}  // namespace barreno
