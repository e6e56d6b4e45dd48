// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/shape.hpp"
#include "scene/table.hpp"

#include <array>
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

enum class PoreConditionKind { drained, flux };

/// What the fluid meets where rock ends: at faces of the grid box, or where it looks along an axis
/// into a cell without solid material. Rock is sealed where nothing is said.
struct PoreConditionSpec {
  std::string name;
  PoreConditionKind kind = PoreConditionKind::drained;
  std::array<bool, 6> grid_faces{};  ///< indexed by Face
  std::array<bool, 6> open_faces{};  ///< of rock, by the direction that they look to
  Table value;  ///< of drained faces the pressure [stress], else the flux into the rock [velocity]
};

enum class Drainage { on, off };

/// Where pressure diffuses less far than this in a run, automatic drainage is off [cells].
inline constexpr double shortest_drained_length = 0.05;

/// Drained pore fluid: Darcy flow between the cells of porous materials. docs/method.md 7
struct PoreFlowSpec {
  Drainage drainage = Drainage::off;
  double viscosity = 0.0;               ///< [stress time]
  Vector fluid_weight{};                ///< rho_f g [force/length^3]
  double diffusion_number = 1.0;        ///< c dt / h^2 between two solves
  std::vector<PermeabilitySpec> rocks;  ///< by material
  std::vector<PoreConditionSpec> conditions;
  /// Belos, Ifpack2 and MueLu, a sublist each; empty ones mean the defaults.
  std::shared_ptr<const Teuchos::ParameterList> solver;
  bool on() const { return drainage == Drainage::on; }
};

}  // namespace barreno
