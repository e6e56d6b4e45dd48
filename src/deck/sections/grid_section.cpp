// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/grid_section.hpp"

#include "deck/section_table.hpp"

#include <algorithm>

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

SectionTable<GridSpec> grid_table() {
  return {
      "Grid",
      "the box that particles may occupy and the cells of the background grid",
      Presence::required,
      {needed(
           &GridSpec::mode,
           "Mode",
           "axisymmetric: {r, axial}; plane strain: {x, y}, per metre; 3D: {x, y, z}"
       ),
       needed(&GridSpec::lower, "Lower", dim::length, any(), "lower corner of the box"),
       needed(
           &GridSpec::upper,
           "Upper",
           dim::length,
           any(),
           "upper corner, a whole number of cells away"
       ),
       if_given(
           &GridSpec::cell_size,
           "Cell Size",
           dim::length,
           above(0.0),
           "edge of the square or cubic cells; without it a deck with a Jet takes the radius of "
           "its "
           "thinnest slug, or with Cells Per Radius a size of one to two radii that becomes that "
           "fine along the path, in either case one that divides the box"
       )}};
}

}  // namespace

template <>
const SectionTable<GridSpec>& table_of<GridSpec>() {
  static const SectionTable<GridSpec> table = grid_table();
  return table;
}

Mode mode_of(const Deck& deck) {
  return DeckValue<Mode>::read(deck, path_of(&GridSpec::mode));
}

void refuse_empty_box(const Deck& deck, const Vector& lower, const Vector& upper) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions(mode_of(deck))); ++i) {
    if (upper[i] > lower[i]) continue;
    deck.refuse_value(
        path_of(&GridSpec::upper),
        std::string("is not above Grid/Lower along ") + "xyz"[i] +
            " (the box is empty); swap the two"
    );
  }
}

Vector vector_at(const Deck& deck, const std::string& path) {
  const Mode mode = mode_of(deck);
  const auto values = deck.vector(path);
  const auto count = static_cast<std::size_t>(dimensions(mode));
  if (values.size() != count) {
    const char* axes = mode == Mode::axisymmetric   ? "{r, axial}"
                       : mode == Mode::plane_strain ? "{x, y}"
                                                    : "{x, y, z}";
    deck.refuse_value(
        path,
        "has " + std::to_string(values.size()) + " components (this mode has " +
            std::to_string(count) + "); write " + axes
    );
  }
  Vector vector{};
  std::copy(values.begin(), values.end(), vector.begin());
  return vector;
}

}  // namespace barreno
