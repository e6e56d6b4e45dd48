// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/load_sections.hpp"

#include "deck/section_table.hpp"

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

SectionTable<ConditionSpec> condition_table() {
  return {
      "Conditions",
      "prescribed motion of the faces of the grid box, one freely named list each",
      Presence::defaulted,
      {needed(&ConditionSpec::face, "Face", "face of the grid box"),
       needed(&ConditionSpec::kind, "Kind", meanings_of(condition_traits)),
       if_given(
           &ConditionSpec::velocity,
           "Velocity",
           dim::velocity,
           any(),
           "only for a prescribed velocity"
       ),
       read_by<ConditionSpec>(
           "read_factors",
           vector(times_word, dim::time, any(), "increasing; Factors is linear in between")
               .if_given()
       ),
       read_by<ConditionSpec>(
           "read_factors",
           vector(factors_word, dim::none, any(), "of Velocity, one for each of Times; default 1")
               .if_given()
       )},
      "one condition"};
}

SectionTable<PressureLoadSpec> load_table() {
  return {
      "Loads",
      "prescribed forces, one freely named list each",
      Presence::defaulted,
      {needed(&PressureLoadSpec::kind, "Kind", meanings_of(load_traits)),
       read_by("body_named", &PressureLoadSpec::body, text("Body", "name of a list in Bodies")),
       read_by(
           "read_faces",
           &PressureLoadSpec::faces,
           words("Faces", all_words<Face>(), "of a box: the loaded faces").if_given()
       ),
       read_by(
           "read_surfaces",
           &PressureLoadSpec::surfaces,
           words("Surfaces", all_words<BallSurface>(), "of a ball: inner (of its cavity) or outer")
               .if_given()
       ),
       read_by(
           "read_pressure",
           &PressureLoadSpec::pressure,
           number(
               pressure_word,
               dim::stress,
               any(),
               "constant in time (or Times and Pressures); for a pore fluid its initial pressure, "
               "default 0"
           )
               .if_given()
       ),
       if_given(
           &PressureLoadSpec::bulk_modulus,
           "Bulk Modulus",
           dim::stress,
           above(0.0),
           "of a pore fluid"
       ),
       read_by<PressureLoadSpec>(
           "read_pressure",
           vector(times_word, dim::time, any(), "increasing; the pressure is linear in between")
               .if_given()
       ),
       read_by<PressureLoadSpec>(
           "read_pressure",
           vector(pressures_word, dim::stress, any(), "one for each of Times").if_given()
       )},
      "one load"};
}

SectionTable<ConfinementSection> confinement_table() {
  return {
      "Confinement",
      "bodies that start in equilibrium under a pressure, which stays on their surfaces",
      Presence::optional,
      {needed(
           &ConfinementSection::pressure,
           "Pressure",
           dim::stress,
           at_least(0.0),
           "on every outer face that has no condition, and on all surfaces of balls"
       ),
       needed(&ConfinementSection::bodies, words("Bodies", {}, "names of lists in Bodies"))}};
}

}  // namespace

template <>
const SectionTable<ConditionSpec>& table_of<ConditionSpec>() {
  static const SectionTable<ConditionSpec> table = condition_table();
  return table;
}

template <>
const SectionTable<PressureLoadSpec>& table_of<PressureLoadSpec>() {
  static const SectionTable<PressureLoadSpec> table = load_table();
  return table;
}

template <>
const SectionTable<ConfinementSection>& table_of<ConfinementSection>() {
  static const SectionTable<ConfinementSection> table = confinement_table();
  return table;
}

}  // namespace barreno
