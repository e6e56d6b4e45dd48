// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/kind_rows.hpp"

namespace barreno {

/// Kinematic condition on the nodes of one face of the grid box (and beyond it).
enum class ConditionKind { symmetry, fixed, prescribed_velocity };

/// What a kind of condition does to a node's velocity, for all who ask. What a plane of symmetry
/// mirrors is its own and asked by its name.
struct ConditionTraits {
  ConditionKind kind;
  const char* word;
  const char* meaning;
  bool slides;  ///< only the component across the face is set
  bool moves;   ///< the components have the deck's Velocity; otherwise they are zero
};
inline constexpr std::array condition_traits{
    ConditionTraits{ConditionKind::symmetry, "symmetry", "no normal velocity", true, false},
    ConditionTraits{ConditionKind::fixed, "fixed", "no velocity", false, false},
    ConditionTraits{
        ConditionKind::prescribed_velocity, "prescribed velocity", "that of Velocity", false, true},
};
static_assert(
    are_in_order(condition_traits), "a row of condition_traits is not at its kind's place"
);

constexpr const ConditionTraits& traits_of(ConditionKind kind) {
  return row_of(condition_traits, kind);
}
inline Words<ConditionKind> words_of(ConditionKind /*of*/) {
  return words_of_rows(condition_traits);
}

}  // namespace barreno
