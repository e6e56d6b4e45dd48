// SPDX-License-Identifier: BSD-3-Clause
#include "deck/deck_schema.hpp"

#include "deck/boundary_sections.hpp"
#include "deck/fidelity.hpp"
#include "deck/pore_flow_section.hpp"
#include "deck/shape_entries.hpp"
#include "deck/step_section.hpp"

#include <algorithm>

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

constexpr Dimension wave_number{-1, 0, 0, 0};

Section grid_section() {
  return {
      "Grid",
      "the box that particles may occupy and the cells of the background grid",
      Presence::required,
      {word(
           "Mode",
           {"axisymmetric", "plane strain", "3D"},
           "axisymmetric: {r, axial}; plane strain: {x, y}, per metre; 3D: {x, y, z}"
       ),
       vector("Lower", dim::length, any(), "lower corner of the box"),
       vector("Upper", dim::length, any(), "upper corner, a whole number of cells away"),
       number("Cell Size", dim::length, above(0.0), "edge of the square or cubic cells")},
      {},
      {}};
}

Section bodies_section() {
  std::vector<Entry> entries{text("Material", "name of a list in Materials")};
  for (const Entry& entry : shape_entries("box")) entries.push_back(entry);
  for (const Entry& entry :
       {integer("Particles Per Cell", between(1, 16), "per direction").by_default("2"),
        vector("Velocity", dim::velocity, any(), "initial velocity; zero without it").if_given(),
        number(
            "Pore Pressure",
            dim::stress,
            at_least(0.0),
            "of the fluid at the start, whatever Confinement presses; without it that of the "
            "material, which in Arenisca the confinement raises undrained"
        )
            .if_given(),
        number("Spin", dim::rate, any(), "about the body's middle, added to Velocity; plane strain")
            .if_given(),
        vector(
            "Velocity Wave Number",
            wave_number,
            any(),
            "k of an initial velocity Velocity * sin(k . x); uniform without it"
        )
            .if_given(),
        number(
            "Radial Velocity",
            dim::velocity,
            any(),
            "of a hollow ball's inner surface, outward, added to Velocity; falls with the distance "
            "as (Inner Radius / "
            "r)^2, in plane strain (Inner Radius / r), so that no volume changes"
        )
            .if_given(),
        vector(
            "Motion",
            dim::velocity,
            any(),
            "makes the body rigid: it moves with this velocity whatever happens, and needs a "
            "material of its own; free without it"
        )
            .if_given(),
        vector("Motion Times", dim::time, any(), "increasing; Motion Factors is linear in between")
            .if_given(),
        vector("Motion Factors", dim::none, any(), "of Motion, one for each of Motion Times")
            .if_given()})
    entries.push_back(entry);
  const Section body = {
      "*", "one body, filled with particles", Presence::required, entries, {}, {}};
  return {
      "Bodies",
      "what is there at time 0, a list of free name each",
      Presence::defaulted,
      {},
      {},
      {body}};
}

Section shapes_section() {
  const Section shape = {"*", "one shape", Presence::required, shape_entries(""), {}, {}};
  return {
      "Shapes",
      "parts that bodies are put together from, a list of free name each",
      Presence::defaulted,
      {},
      {},
      {shape}};
}

Section jet_section() {
  return {
      "Jet",
      "a jet launched along y through a plane, from a table of slugs",
      Presence::optional,
      {text("Material", "name of a list in Materials"),
       file("Table", "CSV file: time,velocity,radius,length,density, a row per slug").if_given(),
       table(
           "Slugs",
           {dim::time, dim::velocity, dim::length, dim::length, dim::density},
           "the same rows in the deck itself, instead of Table"
       )
           .if_given(),
       number("Launch Position", dim::length, any(), "y of the launch plane"),
       word("Direction", {"+y", "-y"}, "where the jet flies"),
       integer("Particles Per Cell", between(1, 16), "per direction").by_default("4")},
      {},
      {}};
}

Section body_force_section() {
  constexpr Dimension acceleration{1, -2, 0, 0};
  return {
      "Body Force",
      "a force per mass on every particle",
      Presence::optional,
      {word(
           "Kind",
           {"gravity", "axis-aligned displacement", "generalized vortex", "expanding ring"},
           "gravity; or a manufactured motion of one Neo-Hookean body, whose exact displacement is "
           "known, to measure the error of the code: axis-aligned displacement of the unit box, "
           "generalized vortex and expanding ring of a hollow disk"
       ),
       vector("Acceleration", acceleration, any(), "of gravity").if_given(),
       number("Amplitude", dim::length, any(), "of a displacement").if_given(),
       number("Angle", dim::none, any(), "amplitude of the vortex, radians").if_given()},
      {},
      {}};
}

Section output_section() {
  return {
      "Output",
      "what is written, and when",
      Presence::defaulted,
      {number("Field Interval", dim::time, at_least(0.0), "between fields; 0: first and last only")
           .by_default("0"),
       number(
           "History Interval",
           dim::time,
           at_least(0.0),
           "between rows of history and depth; 0: every step; forces on rigid bodies are means "
           "over it"
       )
           .by_default("0"),
       number(
           "Checkpoint Wall Interval",
           dim::time,
           at_least(0.0),
           "of your own time between two checkpoints; 0: no bound. The end of a run and a signal "
           "write one in any case"
       )
           .by_default("600 s"),
       number("Checkpoint Interval", dim::time, at_least(0.0), "simulated, likewise; 0: no bound")
           .by_default("0"),
       integer("Checkpoint Steps", at_least(0), "steps, likewise; 0: no bound").by_default("0"),
       word("Particle Glyph", {"deformed", "point"}, "particles as deformed cells or as points")
           .by_default("deformed"),
       word(
           "Particle Files",
           {"one", "one per rank"},
           "particles.e, or for large runs particles.e.N.0 to .N-1 on N ranks, each written by its "
           "own rank; ParaView and epu take such a set as one"
       )
           .by_default("one")},
      {},
      {}};
}

Section build_schema() {
  Section materials = {
      "Materials",
      "what the bodies are made of, a list of free name each",
      Presence::required,
      {},
      {},
      {any_material_section()}};
  materials.named_read_elsewhere = true;
  const Section time = {
      "Time",
      "how long",
      Presence::required,
      {number("End Time", dim::time, above(0.0), "end of the run")},
      {},
      {}};
  return {
      "Deck",
      "a run",
      Presence::required,
      {integer(
           "Schema Version", any(), "version of this table: " + std::to_string(deck_schema_version)
       )
           .such_as(std::to_string(deck_schema_version)),
       text("Title", "one line for screens and files").by_default(""),
       text("Units", "of plain numbers: SI, or units of length, time and mass (\"mm-us-g\")")
           .by_default("SI"),
       word(
           "Fidelity",
           fidelity_words(),
           "a set of choices between error and cost (" + fidelity_text() +
               "), for what the deck does not say itself; errors were measured for the depth of a "
               "jet with "
               "cells of its radius, the pressures of a shock and smooth strains of 0.3: "
               "docs/trade.md"
       )
           .if_given()},
      {grid_section(),
       materials,
       shapes_section(),
       bodies_section(),
       conditions_section(),
       loads_section(),
       confinement_section(),
       jet_section(),
       body_force_section(),
       contact_section(),
       pore_flow_section(),
       step_section(),
       quasi_static_section(),
       time,
       output_section()},
      {}};
}

}  // namespace

const input::Section& deck_schema() {
  static const input::Section schema = build_schema();
  return schema;
}

input::Section any_material_section() {
  return {
      "*",
      "one material: a card, a model with its parameters, or a card with single values overridden",
      Presence::required,
      {file(
           "Card",
           "file of a card, with or without .xml: beside the deck, in materials/cards or in "
           "BARRENO_MATERIALS"
       )
           .if_given(),
       word(
           "Bad Particles",
           {"remove", "hold", "stop"},
           "what becomes of a particle whose update fails, that expands too far or is turned "
           "inside "
           "out; one that leaves the grid is always removed"
       )
           .by_default("remove")},
      {},
      {}};
}

input::Section material_section(const ModelDescription& model) {
  input::Section section = card_section(model);
  // The deck says these once, for everything in it.
  auto& entries = section.entries;
  entries.erase(
      std::remove_if(
          entries.begin(),
          entries.end(),
          [](const auto& e) { return e.name == "Schema Version" || e.name == "Units"; }
      ),
      entries.end()
  );
  const input::Section common = any_material_section();
  entries.insert(entries.begin(), common.entries.begin(), common.entries.end());
  return section;
}

}  // namespace barreno
