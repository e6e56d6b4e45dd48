// SPDX-License-Identifier: BSD-3-Clause
#include "deck/face.hpp"

#include "deck/deck_value.hpp"

namespace barreno {

Face face_at(const Deck& deck, const std::string& path, const std::string& word) {
  for (const Word<Face>& each : words_of(Face{})) {
    if (word != each.word) continue;
    const int axis = static_cast<int>(each.value) / 2;
    if (axis < dimensions(mode_of(deck))) return each.value;
  }
  deck.refuse_value(
      path,
      "names a face that does not exist in this mode (it has x and y only); choose one of those"
  );
}

}  // namespace barreno
