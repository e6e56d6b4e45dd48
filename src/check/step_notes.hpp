// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <string>

namespace barreno {

/// A warning that confined bodies will ring: linear functions and splines do not hold the pressure
/// on a face that lies inside a cell in balance with the stress of its particles. Empty if there is
/// none.
std::string ringing_note(const Scene& scene);

/// A warning that a jet meets refined cells with the Largest Strain of other decks (docs/method.md,
/// 4). Empty if there is none.
std::string largest_strain_note(const Scene& scene);

}  // namespace barreno
