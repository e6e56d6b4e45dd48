// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/metal/fracture.hpp"
#include "barreno/metal/johnson_cook_flow.hpp"
#include "barreno/metal/mie_gruneisen.hpp"

#ifdef BARRENO_OUTSIDE_METALS
// Parts of a program that builds the library with parts of its own (docs/extending.md).
#include BARRENO_OUTSIDE_METALS
#else
namespace barreno::metal::outside {
using Strengths = PartList<>;
using EquationsOfState = PartList<>;
using Failures = PartList<>;
}  // namespace barreno::metal::outside
#endif

namespace barreno::metal {

// The lists of parts that a metal is made of: the one line that a new part adds. Every strength
// goes with every equation of state and every failure. docs/extending.md says what a part provides.
using Strengths = JoinedLists<PartList<JohnsonCookFlow>, outside::Strengths>::type;
using EquationsOfState = JoinedLists<PartList<MieGruneisen>, outside::EquationsOfState>::type;
using Failures = JoinedLists<PartList<Fracture>, outside::Failures>::type;

/// " with NAME" of a part that is not the first of its list: a card's model is named by its
/// strength, and by the other parts where they are not the usual ones.
template <class Part, class List>
struct NameBeside;
template <class Part, class First, class... Rest>
struct NameBeside<Part, PartList<First, Rest...>> {
  static constexpr bool usual = std::is_same_v<Part, First>;
  static constexpr const char* preposition = usual ? "" : " with ";
  static constexpr const char* name = usual ? "" : Part::name;
};

}  // namespace barreno::metal
