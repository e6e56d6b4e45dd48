// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/patch.hpp"

namespace barreno {

/// A patch of tiles that have 2^tile_bits cells along each axis; else as make_patch().
Patch make_patch(int dimensions, int reach, int tile_bits);

}  // namespace barreno
