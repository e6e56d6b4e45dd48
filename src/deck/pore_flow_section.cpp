// SPDX-License-Identifier: BSD-3-Clause
#include "deck/pore_flow_section.hpp"

#include "deck/boundary_sections.hpp"

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

Section rocks_section() {
  const Section rock = {
      "*",
      "the permeability of one of Materials, whose model must have a fluid that drains",
      Presence::required,
      {vector(
           "Permeability",
           dim::area,
           at_least(0.0),
           "one number, or one along each axis; 0: nothing flows"
       ),
       flag("Kozeny-Carman", "permeability times (phi/phi0)^3 ((1-phi0)/(1-phi))^2")
           .by_default("false")},
      {},
      {}};
  return {"Rocks", "by the names in Materials", Presence::required, {}, {}, {rock}};
}

Section conditions_of_flow() {
  const Section condition = {
      "*",
      "one condition",
      Presence::required,
      {word(
           "Kind",
           {"drained", "flux"},
           "drained: the fluid outside has this Pressure; flux: fluid comes in at this Flux"
       ),
       words("Grid Faces", {face_names.begin(), face_names.end()}, "faces of the grid box")
           .if_given(),
       words(
           "Open Faces",
           {face_names.begin(), face_names.end()},
           "where rock looks to this side into a cell that holds nothing solid: outer surfaces, "
           "and "
           "the channel as a jet opens it"
       )
           .if_given(),
       number("Pressure", dim::stress, any(), "of the fluid outside (or Times and Pressures)")
           .if_given(),
       vector("Times", dim::time, any(), "increasing; the pressure is linear in between")
           .if_given(),
       vector("Pressures", dim::stress, any(), "one for each of Times").if_given(),
       number("Flux", dim::velocity, any(), "volume per area and time, negative: out").if_given()},
      {},
      {}};
  return {
      "Conditions",
      "of the fluid, a list of free name each; rock is sealed where none is",
      Presence::defaulted,
      {},
      {},
      {condition}};
}

/// Handed on as it is.
Section library_section(const std::string& name, const std::string& meaning) {
  Section section{name, meaning, Presence::optional, {}, {}, {}};
  section.read_elsewhere = true;
  return section;
}

}  // namespace

Section pore_flow_section() {
  return {
      "Pore Flow",
      "pore fluid that drains through the rock",
      Presence::optional,
      {word(
           "Drainage",
           {"automatic", "on", "off"},
           "automatic: off where pressure cannot diffuse as far as a twentieth of a cell"
       )
           .by_default("automatic"),
       number("Viscosity", dim::viscosity, above(0.0), "of the fluid"),
       number("Fluid Density", dim::density, at_least(0.0), "moves the fluid under gravity")
           .by_default("1000"),
       number(
           "Diffusion Number",
           dim::none,
           above(0.0),
           "largest c dt / h^2 that waits for one solve, c the diffusivity at fixed strain"
       )
           .by_default("1")},
      {rocks_section(),
       conditions_of_flow(),
       library_section(
           "Belos",
           "the linear solver in its own words, and Solver, its name: CG without it; Convergence "
           "Tolerance is of the true residual, 1e-10 without it"
       ),
       library_section(
           "Ifpack2",
           "a preconditioner in its own words, and Type, its name; symmetric Gauss-Seidel without "
           "it, for up to 2000 cells or short intervals"
       ),
       library_section(
           "MueLu",
           "a multigrid preconditioner in its own words; smoothed aggregation without it, for more "
           "cells and long intervals (docs/performance.md)"
       )},
      {}};
}

}  // namespace barreno
