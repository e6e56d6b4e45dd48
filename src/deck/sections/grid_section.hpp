// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"
#include "deck/words.hpp"
#include "geometry/shape.hpp"

#include <string>
#include <vector>

namespace barreno {

class Deck;

/// In axisymmetry x = r, y = axial and z = hoop; vectors carry three components, two-dimensional
/// modes use the first two.
enum class Mode { axisymmetric, plane_strain, three_dimensional };
inline Words<Mode> words_of(Mode /*of*/) {
  return {
      {"axisymmetric", Mode::axisymmetric},
      {"plane strain", Mode::plane_strain},
      {"3D", Mode::three_dimensional}};
}

/// Coordinates of a mode.
inline int dimensions(Mode mode) {
  return mode == Mode::three_dimensional ? 3 : 2;
}

/// Cells of a refined tile are at most 2^max_level times smaller than the grid's.
constexpr int max_level = 4;

struct GridSpec {
  Mode mode = Mode::axisymmetric;
  Vector lower{}, upper{};  ///< corners of the box that particles may occupy [length]
  double cell_size = 0.0;   ///< of tiles of level 0 [length]
  /// Of every tile of the box, x fastest; empty: all are of level 0 (scene/tile_levels.hpp).
  std::vector<unsigned char> level_of_tile;
  /// Parcels that the box is divided into among ranks, at most (grid/parcels.hpp).
  std::size_t most_parcels = std::size_t{1} << 21U;
};
template <>
const SectionTable<GridSpec>& table_of<GridSpec>();

Mode mode_of(const Deck& deck);

/// @throws DeckError where the upper corner is not above the lower one along all axes of the mode
void refuse_empty_box(const Deck& deck, const Vector& lower, const Vector& upper);

/// A vector with one component per dimension of the deck's mode. @throws DeckError for others
Vector vector_at(const Deck& deck, const std::string& path);

}  // namespace barreno
