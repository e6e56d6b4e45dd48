// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/sections/load_sections.hpp"

#include <array>
#include <cstddef>

namespace barreno {

/// What a kind of load is, for all who ask: one row for each kind.
struct LoadTraits {
  LoadKind kind;
  bool absorbs;       ///< its faces absorb waves
  bool steady;        ///< its pressure is the deck's: it does not follow from the state
  bool on_faces;      ///< it may act on the faces of boxes
  bool on_surfaces;   ///< it may act on the surfaces of balls
  bool fills_hollow;  ///< it is a fluid in the hollow of a ball
  bool preload;       ///< it may do without a pressure, and then takes that of the confinement
};
inline constexpr std::array load_traits{
    LoadTraits{LoadKind::pressure, false, true, true, true, false, false},
    LoadTraits{LoadKind::non_reflecting, true, true, true, false, false, true},
    LoadTraits{LoadKind::pore_fluid, false, false, false, true, true, false},
};

/// The row of a kind: rows stand in the order of the enumeration.
constexpr const LoadTraits& traits_of(LoadKind kind) {
  return load_traits[static_cast<std::size_t>(kind)];
}
namespace detail {
constexpr bool load_traits_are_in_order() {
  for (std::size_t i = 0; i < load_traits.size(); ++i)
    if (static_cast<std::size_t>(load_traits[i].kind) != i) return false;
  return true;
}
static_assert(load_traits_are_in_order(), "a row of load_traits is not at its kind's place");
}  // namespace detail

}  // namespace barreno
