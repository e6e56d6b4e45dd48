// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/kind_rows.hpp"

namespace barreno {

/// What becomes of the voids that a table's slugs leave: gaps between pieces, a thinner jet, or
/// voids in its material (docs/jets.md).
enum class JetKind { discrete, thinned, continuous };

/// What a kind of jet is, for all who ask; its slugs are those of scene/jet_kinds.hpp.
struct JetTraits {
  JetKind kind;
  const char* word;
  const char* meaning;
  const char* rest;  ///< what `check` says of the jet's length that metal does not fill
  bool touching;     ///< its slugs follow each other without gaps
  bool expanded;     ///< its slugs have the mean density: voids are an expansion strain
};
inline constexpr std::array jet_traits{
    JetTraits{
        JetKind::discrete,
        "discrete",
        "gaps between slugs of full density, of a jet that has broken up",
        "the rest are gaps, as after break-up (docs/jets.md)",
        false,
        false},
    JetTraits{
        JetKind::thinned,
        "thinned",
        "slugs touch, with full density and a smaller radius, of a solid liner before break-up",
        "so the radius is smaller",
        true,
        false},
    JetTraits{
        JetKind::continuous,
        "continuous",
        "slugs touch, with the mean density, and voids are an expansion strain of the material, of "
        "a powder liner",
        "the rest are voids in it",
        true,
        true},
};
static_assert(are_in_order(jet_traits), "a row of jet_traits is not at its kind's place");

constexpr const JetTraits& traits_of(JetKind kind) {
  return row_of(jet_traits, kind);
}
inline Words<JetKind> words_of(JetKind /*of*/) {
  return words_of_rows(jet_traits);
}

}  // namespace barreno
