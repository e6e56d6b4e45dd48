// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/particles.hpp"

#include <array>
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

/// The values of a view where the host can read them.
template <class View>
auto on_host(const View& view) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
}

/// What is read of one particle set on the host: by files, the screen and the measures of a jet.
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

/// In-plane part of F and its determinant with the hoop or out-of-plane stretch, which only
/// axisymmetry has.
struct PlaneStretch {
  double plane[4];
  double determinant;
};
PlaneStretch plane_stretch(const HostParticles::Values& deformation_gradient, int p);

}  // namespace barreno
