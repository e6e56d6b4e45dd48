// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace barreno {

class Deck;

/// What does not work across cells of different sizes yet, as the deck calls it; empty: all does.
/// Automatic drainage, which build_scene decides by the rock's storage, counts until then.
std::string conflict_with_levels(const Deck& deck, bool flow_decided = false);

struct JetCells {
  double size = 0.0;  ///< of level 0 [length]
  std::string note;   ///< for the user
};

/// Grid/Cell Size where a deck with a jet leaves it open. With N Cells Per Radius (without
/// a refined path 1) and r the radius of the thinnest slug, the cells of the path are to be r / N
/// or less, and the others 2^l times that, with the least l that makes them r or more:
///
///   h = 2^l r / N,   l = ceil(log2 N),   at most max_level,
///
/// or a little less, so that they divide the box along all axes.
/// @throws DeckError without a jet, or where no such size divides the box
JetCells cells_of_jet(const Deck& deck);

}  // namespace barreno
