// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/kind_rows.hpp"

namespace barreno {

enum class LoadKind { pressure, non_reflecting, pore_fluid };

/// What a kind of load is, for all who ask.
struct LoadTraits {
  LoadKind kind = LoadKind::pressure;
  const char* word = "";
  const char* meaning = "";
  const char* feature = "";   ///< its name in the table of features that `check` prints
  bool absorbs = false;       ///< its faces absorb waves
  bool steady = true;         ///< its pressure is the deck's: it does not follow from the state
  bool fills_hollow = false;  ///< it is a fluid in the hollow of a ball
  bool preload = false;       ///< it may do without a pressure, and takes that of the confinement
  /// What is wrong with a body of that shape, and what to do; null: the load may act on it.
  const char *why_no_box = nullptr, *why_no_ball = nullptr;
  /// For what a deck's Surfaces, and its Times and Pressures, have no meaning; null: it may give
  /// them.
  const char *no_surfaces = nullptr, *no_times = nullptr;
};
namespace load_rows {

constexpr LoadTraits pressure() {
  LoadTraits row;
  row.kind = LoadKind::pressure;
  row.word = "pressure";
  row.meaning = "follows the surface, pushes inward when positive";
  row.feature = "pressure loads";
  return row;
}

constexpr LoadTraits non_reflecting() {
  LoadTraits row;
  row.kind = LoadKind::non_reflecting;
  row.word = "non-reflecting";
  row.meaning =
      "the same (or the confinement's, or none), and waves that reach these faces of a box leave "
      "through them";
  row.feature = "non-reflecting faces";
  row.absorbs = true;
  row.preload = true;
  row.why_no_ball = "names a ball, but only the faces of boxes can be non-reflecting; choose a box";
  return row;
}

constexpr LoadTraits pore_fluid() {
  LoadTraits row;
  row.kind = LoadKind::pore_fluid;
  row.word = "pore fluid";
  row.meaning = "fills the cavity of a ball, p = Pressure - Bulk Modulus ln(V / V0)";
  row.feature = "fluid in cavities";
  row.steady = false;
  row.fills_hollow = true;
  row.why_no_box = "names a box, which has no hollow for a pore fluid; choose a hollow ball";
  row.no_surfaces = "a pore fluid, which fills the hollow";
  row.no_times = "a pore fluid, whose pressure follows from its volume";
  return row;
}

}  // namespace load_rows
inline constexpr std::array load_traits{
    load_rows::pressure(), load_rows::non_reflecting(), load_rows::pore_fluid()};
static_assert(are_in_order(load_traits), "a row of load_traits is not at its kind's place");

constexpr const LoadTraits& traits_of(LoadKind kind) {
  return row_of(load_traits, kind);
}
inline Words<LoadKind> words_of(LoadKind /*of*/) {
  return words_of_rows(load_traits);
}

}  // namespace barreno
