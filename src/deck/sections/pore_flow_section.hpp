// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/face.hpp"
#include "deck/section_of.hpp"
#include "deck/table.hpp"
#include "deck/words.hpp"
#include "geometry/shape.hpp"

#include <barreno/input/schema.hpp>
#include <memory>
#include <string>
#include <vector>

namespace Teuchos {
class ParameterList;
}

namespace barreno {

/// How well a rock lets its fluid through.
struct PermeabilitySpec {
  Vector permeability{};       ///< along the axes; 0: none [length^2]
  bool kozeny_carman = false;  ///< times (phi/phi0)^3 ((1-phi0)/(1-phi))^2
};
template <>
const SectionTable<PermeabilitySpec>& table_of<PermeabilitySpec>();

enum class PoreConditionKind { drained, flux };
inline Words<PoreConditionKind> words_of(PoreConditionKind /*of*/) {
  return {{"drained", PoreConditionKind::drained}, {"flux", PoreConditionKind::flux}};
}

/// What the fluid meets where rock ends: at faces of the grid box, or where it looks along an axis
/// into a cell without solid material. Rock is sealed where nothing is said.
struct PoreConditionSpec {
  std::string name;
  PoreConditionKind kind = PoreConditionKind::drained;
  FaceSet grid_faces{};
  FaceSet open_faces{};  ///< of rock, by the direction that they look to
  Table value;  ///< of drained faces the pressure [stress], else the flux into the rock [velocity]
};
template <>
const SectionTable<PoreConditionSpec>& table_of<PoreConditionSpec>();

/// Automatic: on where pressure diffuses far enough in the run; build_scene decides that.
enum class Drainage { automatic, on, off };
inline Words<Drainage> words_of(Drainage /*of*/) {
  return {{"automatic", Drainage::automatic}, {"on", Drainage::on}, {"off", Drainage::off}};
}

/// Where pressure diffuses less far than this in a run, automatic drainage is off [cells].
inline constexpr double shortest_drained_length = 0.05;

/// What the linear solver does where its lists say nothing: residual over right-hand side to which
/// it solves, and the number of cells below which it takes a smoother instead of multigrid.
inline constexpr double default_solver_tolerance = 1e-10;
inline constexpr int fewest_cells_for_multigrid = 2000;

/// Drained pore fluid: Darcy flow between the cells of porous materials. docs/method.md 7
struct PoreFlowSpec {
  Drainage drainage = Drainage::automatic;
  double viscosity = 0.0;               ///< [stress time]
  double fluid_density = 1000.0;        ///< [mass/length^3]
  Vector fluid_weight{};                ///< rho_f g [force/length^3]
  double diffusion_number = 1.0;        ///< c dt / h^2 between two solves
  std::vector<PermeabilitySpec> rocks;  ///< by material
  std::vector<PoreConditionSpec> conditions;
  /// Belos, Ifpack2 and MueLu, a sublist each; empty ones mean the defaults.
  std::shared_ptr<const Teuchos::ParameterList> solver;
  bool on() const { return drainage == Drainage::on; }
};
template <>
const SectionTable<PoreFlowSpec>& table_of<PoreFlowSpec>();

/// Lists below it that are handed to the libraries of their names: Belos, Ifpack2, MueLu.
std::vector<std::string> solver_lists();

/// With the lists of rocks, conditions and solver below it.
input::Section pore_flow_section();

}  // namespace barreno
