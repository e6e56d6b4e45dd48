// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/kind_rows.hpp"

namespace barreno {

enum class LoadKind { pressure, non_reflecting, pore_fluid };

/// What a kind of load is, for all who ask.
struct LoadTraits {
  LoadKind kind;
  const char* word;
  const char* meaning;
  const char* feature;  ///< its name in the table of features that `check` prints
  bool absorbs;         ///< its faces absorb waves
  bool steady;          ///< its pressure is the deck's: it does not follow from the state
  bool on_faces;        ///< it may act on the faces of boxes
  bool on_surfaces;     ///< it may act on the surfaces of balls
  bool fills_hollow;    ///< it is a fluid in the hollow of a ball
  bool preload;         ///< it may do without a pressure, and then takes that of the confinement
};
inline constexpr std::array load_traits{
    LoadTraits{
        LoadKind::pressure,
        "pressure",
        "follows the surface, pushes inward when positive",
        "pressure loads",
        false,
        true,
        true,
        true,
        false,
        false},
    LoadTraits{
        LoadKind::non_reflecting,
        "non-reflecting",
        "the same (or the confinement's, or none), and waves that reach these faces of a box leave "
        "through them",
        "non-reflecting faces",
        true,
        true,
        true,
        false,
        false,
        true},
    LoadTraits{
        LoadKind::pore_fluid,
        "pore fluid",
        "fills the cavity of a ball, p = Pressure - Bulk Modulus ln(V / V0)",
        "fluid in cavities",
        false,
        false,
        false,
        true,
        true,
        false},
};
static_assert(are_in_order(load_traits), "a row of load_traits is not at its kind's place");

constexpr const LoadTraits& traits_of(LoadKind kind) {
  return row_of(load_traits, kind);
}
inline Words<LoadKind> words_of(LoadKind /*of*/) {
  return words_of_rows(load_traits);
}

}  // namespace barreno
