// SPDX-License-Identifier: BSD-3-Clause
#include "state/host_particles.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
Corners domain_corners(const double x[2], const double F[4], const double h[2]) {
  constexpr double sign[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const double X = h[0] / std::max(1.0, std::hypot(F[0], F[2]) / longest_stretch_drawn);
  const double Y = h[1] / std::max(1.0, std::hypot(F[1], F[3]) / longest_stretch_drawn);
  Corners corners{};
  for (std::size_t a = 0; a < 4; ++a) {
    corners[2 * a] = x[0] + sign[a][0] * X * F[0] + sign[a][1] * Y * F[1];
    corners[2 * a + 1] = x[1] + sign[a][0] * X * F[2] + sign[a][1] * Y * F[3];
  }
  return corners;
}

SpaceCorners domain_corners_3d(const double x[3], const double F[9], const double h[3]) {
  constexpr double sign[8][3] = {
      {-1, -1, -1},
      {1, -1, -1},
      {1, 1, -1},
      {-1, 1, -1},
      {-1, -1, 1},
      {1, -1, 1},
      {1, 1, 1},
      {-1, 1, 1}};
  double drawn[3];
  for (std::size_t k = 0; k < 3; ++k)
    drawn[k] = h[k] / std::max(1.0, std::hypot(F[k], F[3 + k], F[6 + k]) / longest_stretch_drawn);
  SpaceCorners corners{};
  for (std::size_t a = 0; a < 8; ++a)
    for (std::size_t i = 0; i < 3; ++i) {
      double& coordinate = corners[3 * a + i] = x[i];
      for (std::size_t k = 0; k < 3; ++k) coordinate += sign[a][k] * drawn[k] * F[3 * i + k];
    }
  return corners;
}

HostParticles::HostParticles(const Particles& particles)
    : count(particles.count),
      id(on_host(particles.id)),
      body(on_host(particles.body)),
      position(on_host(particles.position.values)),
      velocity(on_host(particles.velocity.values)),
      deformation_gradient(on_host(particles.deformation_gradient.values)),
      rotation(on_host(particles.rotation.values)),
      stress(on_host(particles.stress.values)),
      mass(on_host(particles.mass.values)),
      volume(on_host(particles.volume.values)),
      half_size(on_host(particles.half_size.values)),
      viscous_pressure(on_host(particles.viscous_pressure.values)),
      history(on_host(particles.history.values)),
      clipped(on_host(particles.clipped.values)),
      darcy_velocity(on_host(particles.darcy_velocity.values)) {}

void HostParticles::append_corners(int p, std::vector<double>& values) const {
  double x[3], h[3], F[9];
  for (int d = 0; d < dimensions(); ++d) {
    x[d] = position(p, d);
    h[d] = half_size(p, d);
  }
  const auto append = [&](const auto& corners) {
    values.insert(values.end(), corners.begin(), corners.end());
  };
  if (dimensions() == 2) {
    append(domain_corners(x, plane_stretch(deformation_gradient, p).plane, h));
    return;
  }
  for (int c = 0; c < 9; ++c) F[c] = deformation_gradient(p, c);
  append(domain_corners_3d(x, F, h));
}

PlaneStretch plane_stretch(const HostParticles::Values& F, int p) {
  PlaneStretch s{{F(p, 0), F(p, 1), F(p, 2), F(p, 3)}, 0.0};
  const double out_of_plane = F.extent(1) > 4 ? F(p, 4) : 1.0;
  s.determinant = (F(p, 0) * F(p, 3) - F(p, 1) * F(p, 2)) * out_of_plane;
  return s;
}

}  // namespace barreno
