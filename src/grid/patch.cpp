// SPDX-License-Identifier: BSD-3-Clause
#include "grid/make_patch.hpp"
#include "scene/tile_size.hpp"

#include <stdexcept>

namespace barreno {
namespace {

int power(int base, int exponent) {
  int out = 1;
  for (int i = 0; i < exponent; ++i) out *= base;
  return out;
}

}  // namespace

Patch make_patch(int dimensions, int reach) {
  return make_patch(dimensions, reach, tile_bits);
}

Patch make_patch(int dimensions, int reach, int bits) {
  Patch patch;
  patch.dimensions = dimensions;
  patch.reach = reach;
  patch.tile_bits = bits;
  patch.tile_cells = 1 << bits;
  patch.nodes = patch.tile_cells + 1 + 2 * reach;
  if (patch.nodes > max_patch_nodes)
    throw std::logic_error("a shape function reaches too far for a patch");
  patch.size = power(patch.nodes, dimensions);
  patch.cells = power(patch.tile_cells, dimensions);
  patch.near = (patch.nodes - 1) / patch.tile_cells;
  patch.neighbours = power(2 * patch.near + 1, dimensions);
  return patch;
}

}  // namespace barreno
