// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/detonation_section.hpp"

#include "deck/section_table.hpp"

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

SectionTable<DetonationSpec> detonation_table() {
  return {
      "Detonation",
      "where and when explosive bodies are lit; every body of a JWL Explosive needs it",
      Presence::optional,
      {needed(
           &DetonationSpec::body_names,
           words("Bodies", {}, "names of lists in Bodies, all of one explosive")
       ),
       defaulted(
           &DetonationSpec::lighting,
           "Lighting",
           "way of the front from its detonators: straight, whatever is in between, or around "
           "obstacles, through these bodies alone (found on the cells of the grid at the start)"
       )}};
}

SectionTable<DetonatorSpec> detonator_table() {
  return {
      "Detonation/Detonators",
      "what lights the explosive, one freely named list each; a point burns from the one whose "
      "front comes first",
      Presence::optional,
      {needed(
           &DetonatorSpec::kind,
           "Kind",
           "point (off the axis of axisymmetry: a ring), line from Position to End, ring about "
           "Position, or plane through Position (the whole of it)"
       ),
       needed(&DetonatorSpec::position, "Position", dim::length, any(), "in one of the bodies"),
       if_given(
           &DetonatorSpec::end, "End", dim::length, any(), "other end of a line, in a body too"
       ),
       if_given(
           &DetonatorSpec::normal,
           "Normal",
           dim::none,
           any(),
           "of a plane; of a ring its axis, which in axisymmetry is the axis"
       ),
       if_given(&DetonatorSpec::radius, "Radius", dim::length, above(0.0), "of a ring"),
       defaulted(
           &DetonatorSpec::time,
           "Time",
           dim::time,
           at_least(0.0),
           "at which it lights all of itself"
       )},
      "one detonator"};
}

}  // namespace

template <>
const SectionTable<DetonationSpec>& table_of<DetonationSpec>() {
  static const SectionTable<DetonationSpec> table = detonation_table();
  return table;
}

template <>
const SectionTable<DetonatorSpec>& table_of<DetonatorSpec>() {
  static const SectionTable<DetonatorSpec> table = detonator_table();
  return table;
}

input::Section detonation_section() {
  Section detonation = section_of<DetonationSpec>();
  detonation.sections = {section_of<DetonatorSpec>()};
  return detonation;
}

}  // namespace barreno
