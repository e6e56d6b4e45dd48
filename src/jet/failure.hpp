// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

namespace barreno {

/// The model is Johnson-Cook's, with voids or without.
bool is_metal(const MaterialSpec& material);

/// A metal with a Spall Stress, or with the damage of D1 to D5.
bool breaks(const MaterialSpec& material);

}  // namespace barreno
