// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/words.hpp"

#include <array>
#include <string>

namespace barreno {

class Deck;

/// Of a box, or of the grid.
enum class Face { x_lower, x_upper, y_lower, y_upper, z_lower, z_upper };
inline Words<Face> words_of(Face /*of*/) {
  return {
      {"x_lower", Face::x_lower},
      {"x_upper", Face::x_upper},
      {"y_lower", Face::y_lower},
      {"y_upper", Face::y_upper},
      {"z_lower", Face::z_lower},
      {"z_upper", Face::z_upper}};
}

/// Faces that are meant, indexed by Face.
using FaceSet = std::array<bool, 6>;

/// The face of that word out of the parameter at `path`. @throws DeckError if the deck's mode has
/// no such face
Face face_at(const Deck& deck, const std::string& path, const std::string& word);

}  // namespace barreno
