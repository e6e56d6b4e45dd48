// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/body_section.hpp"

#include "deck/material_named.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/shape_section.hpp"

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

constexpr Dimension wave_number{-1, 0, 0, 0};

SectionTable<BodySpec> body_table() {
  return {
      "Bodies",
      "the bodies present at time 0, one freely named list each",
      Presence::defaulted,
      {material_named(&BodySpec::material, "Material", "name of a list in Materials"),
       defaulted(
           &BodySpec::particles_per_cell, "Particles Per Cell", between(1, 16), "per direction"
       ),
       if_given(
           &BodySpec::velocity,
           "Velocity",
           dim::velocity,
           any(),
           "initial velocity; zero without it"
       ),
       if_given(
           &BodySpec::pore_pressure,
           "Pore Pressure",
           dim::stress,
           at_least(0.0),
           "initial pressure of the fluid, regardless of Confinement; without it that of the "
           "material, which in Arenisca rises under the confinement as if undrained"
       ),
       if_given(
           &BodySpec::expansion,
           "Expansion",
           dim::none,
           at_least(1.0),
           "solid over mean density at the start: a porous metal, whose material needs Expansion "
           "Strain; 1 without it"
       ),
       if_given(
           &BodySpec::spin,
           "Spin",
           dim::rate,
           any(),
           "about the body's centre, added to Velocity; plane strain"
       ),
       if_given(
           &BodySpec::velocity_wave_number,
           "Velocity Wave Number",
           wave_number,
           any(),
           "k of an initial velocity Velocity * sin(k . x); uniform without it"
       ),
       if_given(
           &BodySpec::radial_velocity,
           "Radial Velocity",
           dim::velocity,
           any(),
           "of a hollow ball's inner surface, outward, added to Velocity; decreases with the "
           "distance as (Inner Radius / r)^2, in plane strain (Inner Radius / r), so that volume "
           "is preserved"
       )},
      "one body, filled with particles"};
}

SectionTable<MotionSpec> motion_table() {
  SectionTable<MotionSpec> table;
  table.path = table_of<BodySpec>().path;
  table.entries = {
      if_given(
          &MotionSpec::velocity,
          "Motion",
          dim::velocity,
          any(),
          "makes the body rigid: it moves with this velocity whatever the forces, and needs its "
          "own material; without it the body moves freely"
      ),
      read_by<MotionSpec>(
          "read_factors",
          vector(
              "Motion Times", dim::time, any(), "increasing; Motion Factors is linear in between"
          )
              .if_given()
      ),
      read_by<MotionSpec>(
          "read_factors",
          vector("Motion Factors", dim::none, any(), "of Motion, one for each of Motion Times")
              .if_given()
      )};
  table.each = table_of<BodySpec>().each;
  return table;
}

}  // namespace

template <>
const SectionTable<BodySpec>& table_of<BodySpec>() {
  static const SectionTable<BodySpec> table = body_table();
  return table;
}

template <>
const SectionTable<MotionSpec>& table_of<MotionSpec>() {
  static const SectionTable<MotionSpec> table = motion_table();
  return table;
}

input::Section bodies_section() {
  Section bodies = section_of<BodySpec>();
  std::vector<Entry>& entries = bodies.named.front().entries;
  const std::vector<Entry> shape = shape_entries();
  entries.insert(entries.begin() + 1, shape.begin(), shape.end());
  const std::vector<Entry> motion = entries_of<MotionSpec>();
  entries.insert(entries.end(), motion.begin(), motion.end());
  return bodies;
}

}  // namespace barreno
