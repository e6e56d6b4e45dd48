// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "deck/section_table.hpp"
#include "scene/geometry.hpp"
#include "scene/input_speeds.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <barreno/models.hpp>
#include <cmath>
#include <variant>

namespace barreno {
namespace {

void check_speed(const Deck& deck, const std::string& path, double speed) {
  if (speed < speed_of_light) return;
  deck.refuse_value(
      path,
      "means " + text_of("%.6g", speed) + " m/s, which is not below the speed of light (" +
          text_of("%.6g", speed_of_light) + " m/s); look for a wrong unit"
  );
}

void check_speeds(const Deck& deck, const Scene& scene) {
  for (const BodySpec& body : scene.bodies) {
    check_speed(deck, path_of(&BodySpec::velocity, body.name), length_of(body.velocity));
    check_speed(
        deck, path_of(&BodySpec::radial_velocity, body.name), std::abs(body.radial_velocity)
    );
    check_speed(deck, path_of(&BodySpec::spin, body.name), rim_speed(body, scene.grid));
    if (body.motion.prescribed)
      check_speed(deck, path_of(&MotionSpec::velocity, body.name), motion_speed(body.motion));
  }
  for (const ConditionSpec& condition : scene.conditions)
    if (traits_of(condition.kind).moves)
      check_speed(deck, path_of(&ConditionSpec::velocity, condition.name), face_speed(condition));
}

/// Sums of mass and energy hold numbers from 6e-61 to 5e39 (ReproducibleSum); within these limits
/// no term of a balance is lost.
constexpr double min_mass = 1e-40;   ///< of a particle [mass]
constexpr double max_energy = 1e36;  ///< of a body, if it were all kinetic or elastic [energy]

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

double max_volume(const BodySpec& body, const GridSpec& grid) {
  const double round = grid.mode == Mode::axisymmetric ? two_pi * grid.upper[0] : 1.0;
  return round * max_measure(body.shape, grid);
}

void check_masses(const Deck& deck, const Scene& scene) {
  for (const BodySpec& body : scene.bodies) {
    const Material& material = scene.materials[static_cast<std::size_t>(body.material)].material();
    const double modulus = std::visit(
        [](const auto& model) {
          return model.longitudinal_modulus({}, model.initial_history(), 1.0);
        },
        material.model
    );
    const double speed = body_speed(body, scene.grid);
    const double mass = material.density * smallest_volume(body, scene.grid);
    const double energy =
        max_volume(body, scene.grid) * (modulus + material.density * speed * speed);
    if (!(mass >= min_mass))
      deck.refuse(
          list_of<BodySpec>(body.name),
          "has particles of " + text_of("%.6g", mass) +
              " kg (mass and energy balances lose their meaning below " +
              text_of("%.6g", min_mass) +
              " kg); look for a wrong unit of its size, its density or of " +
              path_of(&GridSpec::cell_size)
      );
    if (!(energy <= max_energy))
      deck.refuse(
          list_of<BodySpec>(body.name),
          "may hold " + text_of("%.6g", energy) + " J (energy balances lose their meaning beyond " +
              text_of("%.6g", max_energy) +
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
    if (mass >= min_mass && whole * slug.velocity * slug.velocity <= max_energy) continue;
    deck.refuse_value(
        jet.table_file.empty() ? path_of(&JetSpec::slugs) : path_of(&JetSpec::table_file),
        "gives slug " + std::to_string(s + 1) + " particles of " + text_of("%.6g", mass) +
            " kg and " + text_of("%.6g", whole * slug.velocity * slug.velocity) +
            " J (mass and energy balances need at least " + text_of("%.6g", min_mass) +
            " kg and at most " + text_of("%.6g", max_energy) +
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
