// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "read_rock_points.hpp"

#include <barreno/models.hpp>
#include <string>
#include <type_traits>
#include <vector>

namespace barreno {

/// A value that a card gets, a number or a word.
struct CardValue {
  const char* name;
  double number = 0.0;
  const char* word = nullptr;
};

/// A form of Arenisca: what is added to a card of dry rock, or a card beside it.
struct RockForm {
  std::string name;
  std::string points;  ///< the recorded ones that it updates
  std::vector<CardValue> values;
  const char* card = nullptr;  ///< a file in the same folder
};

/// Every form of Arenisca: dry, wet, each feature alone and all together; those with damage and
/// heat, whose cards have many values; then those for comparison.
std::vector<RockForm> rock_forms();

/// The card as that form, with a tolerance.
/// @throws FileError, InputError
Material make_form(const std::string& card, const RockForm& form, double tolerance);

/// What was added, as a reader of cards would write it, or the card.
std::string words_of(const RockForm& form);

template <class Model>
inline constexpr bool is_arenisca = std::is_same_v<typename Model::Parameters, AreniscaParameters>;

/// Whether a model is the published form of the pore fluid.
inline bool is_published(const AreniscaParameters& p) {
  return p.fluid_B0 > 0.0 && p.backstress_strain != AreniscaParameters::poroplastic;
}

/// Points as a model would have them. The published forms get points with the same effective
/// stress, which in them is counted from the stress of the elastic centre.
template <class Model>
std::vector<test::PointOf<Model>> points_for(
    const Model& model,
    const std::vector<std::string>& names,
    const std::vector<RecordedPoint>& recorded
) {
  auto points = points_of(model, names, recorded);
  const AreniscaParameters& card = model.parameters();
  for (auto& p : points) {
    if constexpr (std::is_same_v<Model, GeneralArenisca>) {
      if (!is_published(card)) continue;
      const arenisca::PointRock rock(model.rock(), p.history.coherence, p.history.fluid_mass_ratio);
      const double zeta = rock.zeta(p.history.plastic_volume_strain);
      p.stress = p.stress + isotropic(p.history.pore_pressure + zeta / 3.0);
    }
  }
  return points;
}

/// The pressure in the pores of a point, 0 where there is none [stress].
template <class History, class = void>
struct PressureIn {
  static double of(const History& /*h*/) { return 0.0; }
};
template <class History>
struct PressureIn<History, std::void_t<decltype(History::pore_pressure)>> {
  static double of(const History& h) { return h.pore_pressure; }
};

}  // namespace barreno
