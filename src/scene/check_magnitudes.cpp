// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "scene/geometry.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace barreno {
namespace {

double length_of(const Vector& v) {
  return std::hypot(v[0], v[1], v[2]);
}
double largest_of(const Table& table) {
  double largest = 0.0;
  for (const double value : table.value) largest = std::max(largest, std::abs(value));
  return largest;
}

void check_speed(const Deck& deck, const std::string& path, double speed) {
  if (speed < speed_of_light) return;
  deck.refuse_value(
      path,
      "means " + text_of("%.6g", speed) + " m/s, which nothing reaches (light has " +
          text_of("%.6g", speed_of_light) + " m/s); look for a wrong unit"
  );
}

/// What a body spins with at its corners, at most.
double rim_speed(const BodySpec& body, const GridSpec& grid) {
  if (body.spin == 0.0) return 0.0;
  const Box box = box_around(body.shape, grid);
  return std::abs(body.spin) * std::hypot(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]);
}

double body_speed(const BodySpec& body, const GridSpec& grid) {
  return length_of(body.velocity) + std::abs(body.radial_velocity) + rim_speed(body, grid);
}

void check_speeds(const Deck& deck, const Scene& scene) {
  for (const BodySpec& body : scene.bodies) {
    const std::string path = "Bodies/" + body.name;
    check_speed(deck, path + "/Velocity", length_of(body.velocity));
    check_speed(deck, path + "/Radial Velocity", std::abs(body.radial_velocity));
    check_speed(deck, path + "/Spin", rim_speed(body, scene.grid));
    if (body.motion.prescribed)
      check_speed(
          deck, path + "/Motion", length_of(body.motion.velocity) * largest_of(body.motion.factor)
      );
  }
  for (const ConditionSpec& condition : scene.conditions)
    if (condition.kind == ConditionKind::prescribed_velocity)
      check_speed(
          deck,
          "Conditions/" + condition.name + "/Velocity",
          length_of(condition.velocity) * largest_of(condition.factor)
      );
}

/// Sums of mass and energy hold numbers from 6e-61 to 5e39 (WholeSum); within these limits no term
/// of a balance is lost.
constexpr double least_mass = 1e-40;  ///< of a particle [mass]
constexpr double most_energy = 1e36;  ///< of a body, if it were all kinetic or elastic [energy]

/// The smallest particle that fills a body, about.
double smallest_volume(const BodySpec& body, const GridSpec& grid) {
  const double size = grid.cell_size / body.particles_per_cell;
  const Box box = box_around(body.shape, grid);
  double volume = 1.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions(grid.mode)); ++i)
    volume *= std::min(size, box.upper[i] - box.lower[i]);
  if (grid.mode != Mode::axisymmetric) return volume;
  return volume * two_pi * (box.lower[0] + 0.5 * std::min(size, box.upper[0] - box.lower[0]));
}

double most_volume(const BodySpec& body, const GridSpec& grid) {
  const double round = grid.mode == Mode::axisymmetric ? two_pi * grid.upper[0] : 1.0;
  return round * most_measure(body.shape, grid);
}

void check_masses(const Deck& deck, const Scene& scene) {
  for (const BodySpec& body : scene.bodies) {
    const Material& material = scene.materials[static_cast<std::size_t>(body.material)].material;
    const double modulus = std::visit(
        [](const auto& model) {
          return model.longitudinal_modulus({}, model.initial_history(), 1.0);
        },
        material.model
    );
    const double speed = body_speed(body, scene.grid);
    const double mass = material.density * smallest_volume(body, scene.grid);
    const double energy =
        most_volume(body, scene.grid) * (modulus + material.density * speed * speed);
    if (!(mass >= least_mass))
      deck.refuse(
          "Bodies/" + body.name,
          "has particles of " + text_of("%.6g", mass) +
              " kg (balances of mass and energy are lost below " + text_of("%.6g", least_mass) +
              " kg); look for a wrong unit of its size, its density or of "
              "Grid/Cell Size"
      );
    if (!(energy <= most_energy))
      deck.refuse(
          "Bodies/" + body.name,
          "may hold " + text_of("%.6g", energy) + " J (balances of energy are lost beyond " +
              text_of("%.6g", most_energy) +
              " J); look for a wrong unit of its size, velocity, density or stiffness"
      );
  }
}

/// Every slug by its thinnest and its fastest.
void check_jet(const Deck& deck, const Scene& scene) {
  const JetSpec& jet = scene.jet;
  if (!jet.present) return;
  const double size = scene.grid.cell_size / jet.particles_per_cell;
  for (std::size_t s = 0; s < jet.slugs.size(); ++s) {
    const JetSlug& slug = jet.slugs[s];
    const double across = std::min(size, slug.radius);
    const double mass = slug.density * std::min(size, slug.length) * across *
                        (scene.grid.mode == Mode::plane_strain ? 1.0 : across);
    const double whole = slug.density * slug.length * slug.radius *
                         (scene.grid.mode == Mode::plane_strain ? 1.0 : slug.radius);
    if (mass >= least_mass && whole * slug.velocity * slug.velocity <= most_energy) continue;
    deck.refuse_value(
        jet.table_file.empty() ? "Jet/Slugs" : "Jet/Table",
        "gives slug " + std::to_string(s + 1) + " particles of " + text_of("%.6g", mass) +
            " kg and " + text_of("%.6g", whole * slug.velocity * slug.velocity) +
            " J (balances of mass and energy need at least " + text_of("%.6g", least_mass) +
            " kg and at most " + text_of("%.6g", most_energy) +
            " J); look for a wrong unit in the table"
    );
  }
}

}  // namespace

void check_magnitudes(const Deck& deck, const Scene& scene) {
  check_speeds(deck, scene);
  check_masses(deck, scene);
  check_jet(deck, scene);
}

}  // namespace barreno
