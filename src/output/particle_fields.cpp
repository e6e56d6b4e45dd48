// SPDX-License-Identifier: BSD-3-Clause
#include "output/particle_fields.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

template <class View>
auto on_host(const View& view) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
}

/// In-plane part of F and its determinant with the hoop or out-of-plane stretch, which only
/// axisymmetry has.
struct Stretch {
  double plane[4];
  double determinant;
};
Stretch stretch(const HostParticles::Values& F, int p) {
  Stretch s{{F(p, 0), F(p, 1), F(p, 2), F(p, 3)}, 0.0};
  const double out_of_plane = F.extent(1) > 4 ? F(p, 4) : 1.0;
  s.determinant = (F(p, 0) * F(p, 3) - F(p, 1) * F(p, 2)) * out_of_plane;
  return s;
}

}  // namespace

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

PlaneStress space_stress(const PlaneStress& s, const double F[4]) {
  // The polar decomposition of a 2x2 matrix with positive determinant in closed form.
  const double a = F[0] + F[3], b = F[2] - F[1];
  const double length = std::hypot(a, b);
  if (length == 0.0) return s;
  const double cosine = a / length, sine = b / length;
  const double cc = cosine * cosine, ss = sine * sine, cs = cosine * sine;
  return {
      cc * s[0] + ss * s[1] - 2.0 * cs * s[3],
      ss * s[0] + cc * s[1] + 2.0 * cs * s[3],
      s[2],
      cs * (s[0] - s[1]) + (cc - ss) * s[3]};
}

HostParticles::HostParticles(const Particles& particles)
    : count(particles.count),
      id(on_host(particles.id)),
      body(on_host(particles.body)),
      position(on_host(particles.position.values)),
      velocity(on_host(particles.velocity.values)),
      deformation_gradient(on_host(particles.deformation_gradient.values)),
      stress(on_host(particles.stress.values)),
      mass(on_host(particles.mass.values)),
      volume(on_host(particles.volume.values)),
      half_size(on_host(particles.half_size.values)),
      viscous_pressure(on_host(particles.viscous_pressure.values)),
      history(on_host(particles.history.values)) {}

Corners HostParticles::corners(int p) const {
  const double x[2] = {position(p, 0), position(p, 1)};
  const double h[2] = {half_size(p, 0), half_size(p, 1)};
  return domain_corners(x, stretch(deformation_gradient, p).plane, h);
}

std::vector<std::string> particle_field_names(const Material& material) {
  std::vector<std::string> names{
      "status",
      "velocity_x",
      "velocity_y",
      "stress_xx",
      "stress_yy",
      "stress_zz",
      "stress_xy",
      "pressure",
      "shear_stress",
      "density",
      "volume_ratio",
      "viscous_pressure"};
  std::visit(
      [&](const auto& model) {
        for (const HistoryField& field : model.history_table()) names.emplace_back(field.name);
      },
      material.model
  );
  return names;
}

void append_particle_fields(
    const HostParticles& particles, int p, double reference_density, std::vector<double>& values
) {
  const auto& sigma = particles.stress;
  const PlaneStress s = space_stress(
      {sigma(p, 0), sigma(p, 1), sigma(p, 2), sigma(p, 3)},
      stretch(particles.deformation_gradient, p).plane
  );
  const double pressure = -(s[0] + s[1] + s[2]) / 3.0;
  const double xx = s[0] + pressure, yy = s[1] + pressure, zz = s[2] + pressure;
  const double second_invariant = 0.5 * (xx * xx + yy * yy + zz * zz) + s[3] * s[3];
  const double density = particles.mass(p, 0) / particles.volume(p, 0);
  const double alive = 1.0;
  values.insert(
      values.end(),
      {alive,
       particles.velocity(p, 0),
       particles.velocity(p, 1),
       s[0],
       s[1],
       s[2],
       s[3],
       pressure,
       std::sqrt(second_invariant),
       density,
       reference_density / density,
       particles.viscous_pressure(p, 0)}
  );
  for (std::size_t c = 0; c < particles.history.extent(1); ++c)
    values.push_back(particles.history(p, c));
}

}  // namespace barreno
