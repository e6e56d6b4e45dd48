// SPDX-License-Identifier: BSD-3-Clause
#include "output/radii.hpp"

#include "base/region.hpp"
#include "state/host_particles.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

const Ball& ball_of(const Scene& scene, int body) {
  return std::get<Ball>(scene.bodies[static_cast<std::size_t>(body)].shape);
}

double power_of(Mode mode, double r) {
  return mode == Mode::plane_strain ? r * r : r * r * r;
}
double root_of(Mode mode, double power) {
  const double positive = std::max(0.0, power);
  return mode == Mode::plane_strain ? std::sqrt(positive) : std::cbrt(positive);
}

/// A sum must be carried that often.
constexpr int rows_per_carry = 1 << 19;

void carry(std::vector<ReproducibleSum>& sums) {
  for (ReproducibleSum& sum : sums) sum.carry();
}

}  // namespace

std::vector<int> hollow_balls(const Scene& scene) {
  std::vector<int> bodies;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const auto* ball = std::get_if<Ball>(&scene.bodies[b].shape);
    if (ball != nullptr && ball->inner_radius > 0.0) bodies.push_back(static_cast<int>(b));
  }
  return bodies;
}

std::vector<RadialMoment> radial_moments(
    const Scene& scene, const State& state, const std::vector<int>& bodies
) {
  std::vector<ReproducibleSum> sums(3 * bodies.size());  // whatever the ranks
  for (const Particles& set : state.particles) {
    const HostParticles particles(set);
    for (int p = 0; p < particles.count; ++p) {
      if (p % rows_per_carry == 0) carry(sums);
      const int body = particles.body(p) & ~debris_bit;
      const auto found = std::find(bodies.begin(), bodies.end(), body);
      if (found == bodies.end()) continue;
      const Vector& centre = ball_of(scene, body).centre;
      const double z = particles.dimensions() == 3 ? particles.position(p, 2) - centre[2] : 0.0;
      const double r =
          std::hypot(particles.position(p, 0) - centre[0], particles.position(p, 1) - centre[1], z);
      ReproducibleSum* const sum = &sums[3 * static_cast<std::size_t>(found - bodies.begin())];
      sum[0] += particles.mass(p, 0);
      sum[1] += particles.mass(p, 0) * power_of(scene.grid.mode, r);
      sum[2] += particles.volume(p, 0);
    }
  }
  carry(sums);
  sum_over_ranks(*state.grid.comm, sums);
  std::vector<RadialMoment> moments;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double mass = sums[3 * i];
    moments.push_back({mass, sums[3 * i + 1] / mass, sums[3 * i + 2]});
  }
  return moments;
}

std::vector<double> start_of_radii(const Scene& scene, const State& state) {
  std::vector<double> start;
  for (const RadialMoment& moment : radial_moments(scene, state, hollow_balls(scene)))
    start.insert(start.end(), {moment.mean_power, moment.volume});
  return start;
}

RadiiWriter::RadiiWriter(
    const Scene& scene,
    const Comm& comm,
    const std::vector<double>& start,
    const std::filesystem::path& path,
    std::uintmax_t kept
)
    : bodies_(hollow_balls(scene)), start_(start) {
  std::string header = "time";
  for (const int body : bodies_) {
    const std::string name = column_name(scene.bodies[static_cast<std::size_t>(body)].name);
    for (const char* radius : {"_inner_radius", "_outer_radius"})
      header.append(",").append(name).append(radius);
  }
  RootWork work(comm);
  work.run([&] {
    file_ = std::make_unique<LineFile>(path, kept);
    if (kept > 0) return;  // it has its header
    file_->append(
        "# SI units: time s; radii m, of hollow balls, from the mass average of r^3 (plane strain: "
        "r^2) and the volume of their particles"
    );
    file_->append(header);
  });
  work.agree();
}

void RadiiWriter::write(const Scene& scene, const State& state) {
  const Region region("write_radii");
  const std::vector<RadialMoment> now = radial_moments(scene, state, bodies_);
  const Mode mode = scene.grid.mode;
  std::vector<double> row{state.clock.time};
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Ball& ball = ball_of(scene, bodies_[i]);
    const double inner = power_of(mode, ball.inner_radius), outer = power_of(mode, ball.radius);
    const double moved = now[i].mean_power - start_[2 * i];
    const double swollen = 0.5 * (outer - inner) * (now[i].volume / start_[2 * i + 1] - 1.0);
    row.push_back(root_of(mode, inner + moved - swollen));
    row.push_back(root_of(mode, outer + moved + swollen));
  }
  RootWork work(*state.grid.comm);
  work.run([&] { file_->append(csv_line(row)); });
  work.agree();
}

}  // namespace barreno
