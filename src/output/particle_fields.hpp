// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "scene/scene.hpp"
#include "state/particles.hpp"

#include <array>
#include <string>
#include <vector>

namespace barreno {

/// Corners of a particle's domain, counter-clockwise as QUAD4 wants them: x y of each.
using Corners = std::array<double, 8>;

/// x_p + F_p (+-h_x, +-h_y), corners (-,-) (+,-) (+,+) (-,+). Edges that are stretched further are
/// drawn with this stretch: neighbours of a torn particle are then seen apart, and needles a
/// thousand times the particle do not fill the picture. The files' volume_ratio is that of F.
inline constexpr double longest_stretch_drawn = 4.0;
Corners domain_corners(
    const double position[2], const double deformation_gradient[4], const double half_size[2]
);

/// The same in three dimensions, corners of the lower z face, then those of the upper, as HEX8
/// wants them: x y z of each. F by rows.
using SpaceCorners = std::array<double, 24>;
SpaceCorners domain_corners_3d(
    const double position[3], const double deformation_gradient[9], const double half_size[3]
);

/// In-plane components xx yy zz xy.
using PlaneStress = std::array<double, 4>;

/// R sigma R^T with F = R U: the unrotated stress in the space frame.
PlaneStress space_stress(const PlaneStress& unrotated, const double deformation_gradient[4]);

/// What the writers read of one particle set, on the host.
struct HostParticles {
  explicit HostParticles(const Particles& particles);

  using Values = FieldView::HostMirror;
  int count = 0;
  ArrayView<ParticleId>::HostMirror id;
  ArrayView<int>::HostMirror body;
  Values position, velocity, deformation_gradient, rotation, stress, mass, volume, half_size;
  Values viscous_pressure, history, clipped, darcy_velocity;

  int dimensions() const { return static_cast<int>(position.extent(1)); }
  void append_corners(int p, std::vector<double>& values) const;
};

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

  void append(int p, std::vector<double>& values) const;
};

/// Element variables of a material in files: the common ones, then the optional ones, then the
/// model's history by its own names.
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
