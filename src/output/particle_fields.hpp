// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "scene/scene.hpp"
#include "state/host_particles.hpp"

#include <array>
#include <string>
#include <vector>

namespace barreno {

/// In-plane components xx yy zz xy.
using PlaneStress = std::array<double, 4>;

/// R sigma R^T with F = R U: the unrotated stress in the space frame.
PlaneStress space_stress(const PlaneStress& unrotated, const double deformation_gradient[4]);

/// What particles of some scenes have.
struct OptionalFields {
  bool clipped = false;         ///< `domain_clipped`
  bool darcy_velocity = false;  ///< of the pore fluid, where it drains
  bool cell_size = false;       ///< where cells are of several sizes
  bool step_length = false;     ///< where steps are (Step/Subcycles)
};
OptionalFields optional_fields(const Scene& scene, const MaterialSpec& material);

/// Size of the cell that each row of a set is in and length of the last step of its tile, where
/// these differ between particles; empty without. A tile that was not active has the longest step
/// of all, a run that has taken none 0.
struct CellsAndSteps {
  CellsAndSteps() = default;
  /// @param tile_steps  last_tile_steps()
  CellsAndSteps(
      const OptionalFields& wanted,
      const Grid& grid,
      const std::vector<double>& tile_steps,
      const Particles& particles
  );
  std::vector<double> cell_size, step_length;

  void append_cell_size(int p, std::vector<double>& values) const;
  void append_step_length(int p, std::vector<double>& values) const;
};

/// Element variables of a material in files: those of particle_field_table(), then the model's
/// history by its own names.
std::vector<std::string> particle_field_names(
    const MaterialSpec& material, int dimensions, const OptionalFields& optional = {}
);

/// Their values for one particle, in that order; `status` is 1.
void append_particle_fields(
    const HostParticles& particles,
    int p,
    double reference_density,
    const CellsAndSteps& own,
    std::vector<double>& values
);

}  // namespace barreno
