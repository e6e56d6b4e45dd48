// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"
#include "geometry/shape.hpp"

#include <barreno/input/schema.hpp>

namespace barreno {

/// A region of the grid whose cells are smaller.
struct RefinedRegion {
  Shape shape;
  int level = 1;  ///< its cells are Cell Size / 2^level wide
};
template <>
const SectionTable<RefinedRegion>& table_of<RefinedRegion>();

/// A region's entries are those of its shape too.
input::Section refinement_section();

}  // namespace barreno
