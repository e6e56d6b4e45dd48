// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

namespace barreno {

/// Whether the scene's shape function deforms with its particles (CPDI, contiguous GIMP).
bool follows_deformation(const Scene& scene);

/// What a user should know of the scene's shape function, a sentence; null if nothing.
const char* shape_warning(const Scene& scene);

}  // namespace barreno
