// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace barreno {

/// What the range of one parameter of a card was measured to do to the hole of perforation.xml
/// (docs/materials/arenisca.md), one at a time, from src/measured/range_effects.csv.
struct RangeEffect {
  std::string card;       ///< without .xml
  std::string parameter;  ///< of the card
  std::string range;      ///< "96.37 MPa to 430.7 MPa"
  std::string known;      ///< "fitted", "recalled", "assumed" or "derived"
  std::string until;      ///< when the runs ended that measured it, with its unit
  /// The answer over that of the card's own value less 1, with the lower and with the upper end.
  struct Change {
    double at_low = 0.0, at_high = 0.0;
  };
  Change depth, probed_depth, volume;
};

struct RangeEffects {
  std::string problem;            ///< why nothing is known, for a sentence; empty: it is
  std::vector<RangeEffect> rows;  ///< of each card, those that change the hole most first
};

/// @param folder  of the file; empty: where it is installed. A file that is missing or broken gives
///                a problem and no rows.
RangeEffects read_range_effects(const std::filesystem::path& folder = {});

/// Those that are installed, read once.
const RangeEffects& range_effects();

/// What is least certain of the rock around the hole: of the longest body in the jet's path, if its
/// card was measured.
struct LeastCertain {
  std::string body;                ///< its name in the deck; empty: nothing was measured
  std::vector<RangeEffect> worst;  ///< at most two, the first one first
};
LeastCertain least_certain(const Scene& scene, const RangeEffects& effects = range_effects());

/// One sentence on it; empty if nothing was measured.
std::string least_certain_sentence(const LeastCertain& least);

}  // namespace barreno
