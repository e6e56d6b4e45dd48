// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/jet_section.hpp"

#include "deck/material_named.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/jet_profile_section.hpp"

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

/// Particles and cells of the jet.
void add_resolution(Entries<JetSpec>& entries) {
  entries.push_back(
      defaulted(&JetSpec::particles_per_cell, "Particles Per Cell", between(1, 16), "per direction")
  );
  entries.push_back(defaulted(
      &JetSpec::splits,
      "Splits",
      between(0, 8),
      "how often a particle that has become wider than half a cell is divided in two; files "
      "keep a place for all of its 2^Splits parts (docs/method.md 15)"
  ));
  entries.push_back(defaulted(
      &JetSpec::cells_per_radius,
      "Cells Per Radius",
      dim::none,
      at_least(0.0),
      "refines the grid along the jet's path, to 2.5 times the radius of its widest slug, "
      "until "
      "at least so many cells fit in the radius of its thinnest slug; depths are converged to "
      "about 1 % with 4 (docs/trade.md). 0 leaves the grid as it is"
  ));
}

SectionTable<JetSpec> jet_table() {
  SectionTable<JetSpec> jet{
      "Jet",
      "a jet launched along y through a plane, from a table of slugs",
      Presence::optional,
      {material_named(&JetSpec::material, "Material", "name of a list in Materials"),
       read_by(
           "include_jet_table",
           &JetSpec::table_file,
           file("Table", "CSV file: time,velocity,radius,length,density, a row per slug").if_given()
       ),
       read_by(
           "table_slugs",
           &JetSpec::slugs,
           table(
               "Slugs",
               {dim::time, dim::velocity, dim::length, dim::length, dim::density},
               "the same rows in the deck itself, in place of Table"
           )
               .if_given()
       ),
       defaulted(
           &JetSpec::kind,
           "Kind",
           "what becomes of the voids of the table, which are densities below the material's and "
           "room between slugs: " +
               meanings_of(jet_traits) + " (docs/jets.md)"
       ),
       defaulted(
           &JetSpec::pieces_below,
           "Pieces Below",
           dim::velocity,
           at_least(0.0),
           "velocity below which the jet has broken up: slower slugs are launched as they stand in "
           "the table, with gaps, also of a thinned or continuous jet; a Profile sets it"
       ),
       needed(
           &JetSpec::launch_position, "Launch Position", dim::length, any(), "y of the launch plane"
       ),
       needed(
           &JetSpec::direction,
           "Direction",
           Words<double>{{"+y", 1.0}, {"-y", -1.0}},
           "direction of flight"
       )}};
  add_resolution(jet.entries);
  return jet;
}

}  // namespace

template <>
const SectionTable<JetSpec>& table_of<JetSpec>() {
  static const SectionTable<JetSpec> table = jet_table();
  return table;
}

input::Section jet_section() {
  Section jet = section_of<JetSpec>();
  jet.sections = {section_of<JetProfileSpec>()};
  return jet;
}

}  // namespace barreno
