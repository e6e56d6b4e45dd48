// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/pore_flow_section.hpp"

#include "deck/section_table.hpp"

#include <barreno/input/scan_xml.hpp>

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

SectionTable<PermeabilitySpec> rock_table() {
  return {
      "Pore Flow/Rocks",
      "permeable materials, one list each, with the name that it has in Materials",
      Presence::required,
      {read_by(
           "read_permeability",
           &PermeabilitySpec::permeability,
           vector(
               "Permeability",
               dim::area,
               at_least(0.0),
               "k in Darcy's law, flow = -(k / Viscosity) grad p (1 darcy is 9.87e-13 m2): one "
               "number, or one along each axis; 0: no flow"
           )
       ),
       defaulted(
           &PermeabilitySpec::kozeny_carman,
           "Kozeny-Carman",
           "true: the permeability follows the porosity phi that deformation leaves: "
           "Permeability times (phi/phi0)^3 ((1-phi0)/(1-phi))^2, phi0 the initial one"
       )},
      "permeability of one material, whose model must have a fluid that can drain"};
}

SectionTable<PoreConditionSpec> flow_condition_table() {
  return {
      "Pore Flow/Conditions",
      "boundary conditions of the fluid, one freely named list each; elsewhere rock is sealed",
      Presence::defaulted,
      {needed(
           &PoreConditionSpec::kind,
           "Kind",
           "drained: the fluid outside has this Pressure; flux: fluid flows in at this Flux"
       ),
       if_given(
           &PoreConditionSpec::grid_faces,
           "Grid Faces",
           "where rock touches these faces of the grid box"
       ),
       if_given(
           &PoreConditionSpec::open_faces,
           "Open Faces",
           "surfaces of the rock that look to these sides, wherever they are: between a cell of "
           "rock and one without solid, so outer surfaces, and the wall of the channel "
           "as a jet opens it"
       ),
       read_by<PoreConditionSpec>(
           "read_pressure",
           number(
               pressure_word, dim::stress, any(), "of the fluid outside (or Times and Pressures)"
           )
               .if_given()
       ),
       read_by<PoreConditionSpec>(
           "read_pressure",
           vector(times_word, dim::time, any(), "increasing; the pressure is linear in between")
               .if_given()
       ),
       read_by<PoreConditionSpec>(
           "read_pressure",
           vector(pressures_word, dim::stress, any(), "one for each of Times").if_given()
       ),
       read_by(
           "read_flux",
           &PoreConditionSpec::value,
           number(
               "Flux",
               dim::velocity,
               any(),
               "volume of fluid per area and time; negative: out of the rock"
           )
               .if_given()
       )},
      "one condition"};
}

SectionTable<PoreFlowSpec> flow_table() {
  return {
      "Pore Flow",
      "pore fluid that drains through the rock",
      Presence::optional,
      {defaulted(
           &PoreFlowSpec::drainage,
           "Drainage",
           "automatic: off where pressure diffuses less than " +
               exact_text(shortest_drained_length) + " cells in the run"
       ),
       needed(&PoreFlowSpec::viscosity, "Viscosity", dim::viscosity, above(0.0), "of the fluid"),
       defaulted(
           &PoreFlowSpec::fluid_density,
           "Fluid Density",
           dim::density,
           at_least(0.0),
           "moves the fluid under gravity"
       ),
       defaulted(
           &PoreFlowSpec::diffusion_number,
           "Diffusion Number",
           dim::none,
           above(0.0),
           "largest c dt / h^2 accumulated between two solves, c the diffusivity at fixed strain"
       )}};
}

/// Handed on as it is.
Section library_section(const std::string& name, const std::string& meaning) {
  Section section{name, meaning, Presence::optional, {}, {}, {}};
  section.read_elsewhere = true;
  return section;
}

std::vector<Section> library_sections() {
  return {
      library_section(
          "Belos",
          "parameters of the linear solver, and Solver, its name (default CG); Convergence "
          "Tolerance applies to the true residual (default " +
              exact_text(default_solver_tolerance) + ")"
      ),
      library_section(
          "Ifpack2",
          "parameters of a preconditioner, and Type, its name; default symmetric Gauss-Seidel, for "
          "fewer than " +
              std::to_string(fewest_cells_for_multigrid) + " cells or short intervals"
      ),
      library_section(
          "MueLu",
          "parameters of a multigrid preconditioner; default smoothed aggregation, for more cells "
          "and long intervals (docs/performance.md)"
      )};
}

}  // namespace

template <>
const SectionTable<PermeabilitySpec>& table_of<PermeabilitySpec>() {
  static const SectionTable<PermeabilitySpec> table = rock_table();
  return table;
}

template <>
const SectionTable<PoreConditionSpec>& table_of<PoreConditionSpec>() {
  static const SectionTable<PoreConditionSpec> table = flow_condition_table();
  return table;
}

template <>
const SectionTable<PoreFlowSpec>& table_of<PoreFlowSpec>() {
  static const SectionTable<PoreFlowSpec> table = flow_table();
  return table;
}

std::vector<std::string> solver_lists() {
  std::vector<std::string> names;
  for (const Section& library : library_sections()) names.push_back(library.name);
  return names;
}

input::Section pore_flow_section() {
  Section flow = section_of<PoreFlowSpec>();
  flow.sections = {section_of<PermeabilitySpec>(), section_of<PoreConditionSpec>()};
  for (const Section& library : library_sections()) flow.sections.push_back(library);
  return flow;
}

}  // namespace barreno
