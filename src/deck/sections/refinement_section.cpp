// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/refinement_section.hpp"

#include "deck/section_table.hpp"
#include "deck/sections/grid_section.hpp"
#include "deck/sections/shape_section.hpp"

namespace barreno {
namespace {

using namespace input;

SectionTable<RefinedRegion> refinement_table() {
  return {
      "Refinement",
      "regions of the grid with smaller cells, one freely named list each",
      Presence::defaulted,
      {needed(
          &RefinedRegion::level,
          "Level",
          between(1, max_level),
          "cells of every tile that the region touches are Cell Size / 2^Level wide; those around "
          "it are halved level by level, a tile at a time"
      )},
      "one region"};
}

}  // namespace

template <>
const SectionTable<RefinedRegion>& table_of<RefinedRegion>() {
  static const SectionTable<RefinedRegion> table = refinement_table();
  return table;
}

input::Section refinement_section() {
  Section refinement = section_of<RefinedRegion>();
  std::vector<Entry>& entries = refinement.named.front().entries;
  const std::vector<Entry> shape = shape_entries();
  entries.insert(entries.begin(), shape.begin(), shape.end());
  return refinement;
}

}  // namespace barreno
