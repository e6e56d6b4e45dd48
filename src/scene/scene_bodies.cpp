// SPDX-License-Identifier: BSD-3-Clause
#include "deck/section_table.hpp"
#include "deck/sections/shape_section.hpp"
#include "scene/geometry.hpp"
#include "scene/materials/liquids.hpp"
#include "scene/porous.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <barreno/input/nearest_name.hpp>
#include <barreno/input/scan_xml.hpp>
#include <limits>

namespace barreno {
namespace {

/// What the deck calls a body's shape.
std::string shape_word_of(const Deck& deck, const std::string& body) {
  return deck.word(input::join(list_of<BodySpec>(body), name_of(&ShapeSection::word)));
}

/// The radial field is infinite at the centre: only a hollow ball can have it.
void check_radial_velocity(const Deck& deck, const BodySpec& body) {
  const std::string entry = path_of(&BodySpec::radial_velocity, body.name);
  if (!deck.has(entry)) return;
  const auto* ball = std::get_if<Ball>(&body.shape);
  if (ball == nullptr || ball->inner_radius == 0.0) {
    deck.refuse_value(
        entry,
        "has no meaning without Inner Radius (it is the velocity of a hollow ball's inner "
        "surface); remove it or make the body a ball with Inner Radius"
    );
  }
  if (deck.has(path_of(&BodySpec::velocity_wave_number, body.name))) {
    deck.refuse_value(
        entry,
        "cannot be combined with Velocity Wave Number (both define the velocity field); remove one "
        "of the two"
    );
  }
}

/// A ring that spins about the axis would need a velocity out of the plane.
void check_spin(const Deck& deck, Mode mode, const BodySpec& body) {
  const std::string entry = path_of(&BodySpec::spin, body.name);
  if (!deck.has(entry)) return;
  if (mode == Mode::axisymmetric)
    deck.refuse_value(
        entry, "has no meaning in axisymmetry (nothing moves around the axis); remove it"
    );
  if (!std::holds_alternative<Box>(body.shape) && !std::holds_alternative<Ball>(body.shape)) {
    deck.refuse_value(
        entry,
        "has no meaning for a " + shape_word_of(deck, body.name) +
            " (only boxes and balls have a centre to spin about); remove it or change Shape"
    );
  }
}

BodySpec read_body(const Deck& deck, const std::string& name, const GridSpec& grid) {
  const std::string path = list_of<BodySpec>(name);
  auto body = read_list<BodySpec>(deck, path);
  body.name = name;
  body.shape = read_shape(deck, path, grid.mode);
  check_radial_velocity(deck, body);
  check_spin(deck, grid.mode, body);
  body.motion = read_motion(deck, name, grid.mode);
  if (!inside(body.shape, grid)) {
    deck.refuse(
        path,
        "reaches outside the grid (particles can only be inside its box); enlarge Grid or move the "
        "body"
    );
  }
  return body;
}

/// A wall, or a solid body's width; infinite where only the lattice tells.
double thickness_of(const Shape& shape) {
  const auto wall = [](double radius, double inner) {
    return inner > 0.0 ? radius - inner : 2.0 * radius;
  };
  if (const auto* ball = std::get_if<Ball>(&shape)) return wall(ball->radius, ball->inner_radius);
  if (const auto* cone = std::get_if<Cone>(&shape))
    return wall(std::max(cone->start_radius, cone->end_radius), cone->inner_radius);
  return std::numeric_limits<double>::infinity();
}

/// Boxes thinner than a particle become thin particles of exact mass; a lattice cannot do that.
void check_filling(const Deck& deck, const Scene& scene, const BodySpec& body) {
  if (std::holds_alternative<Box>(body.shape)) return;
  const std::string path = list_of<BodySpec>(body.name);
  const double size = scene.grid.cell_size / body.particles_per_cell;
  constexpr double min_filled = 0.5;
  const double fullest = fullest_cell(
      body.shape, dimensions(scene.grid.mode), lattice_of(body.shape, scene.grid, size), min_filled
  );
  if (fullest == 0.0) {
    deck.refuse(
        path, "is empty (no point of the grid lies inside it); change its shape or its parts"
    );
  }
  if (thickness_of(body.shape) < size || fullest < min_filled) {
    deck.refuse(
        path,
        "is thinner than a particle, which is " + input::exact_text(size) +
            " m wide (its stress could not be resolved); make cells smaller, Particles Per Cell "
            "larger or the body thicker"
    );
  }
}

}  // namespace

int body_named(
    const Deck& deck, const Scene& scene, const std::string& path, const std::string& name
) {
  std::vector<std::string> names;
  for (const BodySpec& body : scene.bodies) names.push_back(body.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    deck.refuse_value(
        path, "names '" + name + "', which is not in Bodies; " + input::suggest_name(name, names)
    );
  }
  const auto index = static_cast<std::size_t>(found - names.begin());
  const Shape& shape = scene.bodies[index].shape;
  if (!std::holds_alternative<Box>(shape) && !std::holds_alternative<Ball>(shape)) {
    deck.refuse_value(
        path,
        "names '" + name + "', which is a " + shape_word_of(deck, name) +
            " (only boxes and balls can carry a surface load); choose one of those"
    );
  }
  return static_cast<int>(index);
}

void check_pore_pressures(const Deck& deck, const Scene& scene) {
  for (const BodySpec& body : scene.bodies) {
    if (!body.pore_pressure) continue;
    const Material& material = scene.materials[static_cast<std::size_t>(body.material)].material();
    const bool possible = std::visit(
        [&](const auto& model) { return initial_state_of(model, body).possible; }, material.model
    );
    if (!possible)
      deck.refuse_value(
          path_of(&BodySpec::pore_pressure, body.name),
          "is not a pressure that '" + material.name +
              "' can start with (Arenisca needs fluid_B0 and a Confinement of at least that, "
              "Poroelastic a Fluid Bulk Modulus); remove it or change one of them"
      );
  }
}

void check_expansions(const Deck& deck, const Scene& scene) {
  for (const BodySpec& body : scene.bodies) {
    if (body.expansion == 1.0) continue;
    const std::string entry = path_of(&BodySpec::expansion, body.name);
    const MaterialSpec& material = scene.materials[static_cast<std::size_t>(body.material)];
    if (!material.holds_voids())
      deck.refuse_value(
          entry,
          "needs a metal that may have voids, which '" + material.name() +
              "' is not (only Johnson-Cook with Expansion Strain = \"on\" is); set that in "
              "Materials, or remove Expansion"
      );
    const double most = material.largest_porous_expansion();
    if (body.expansion >= most)
      deck.refuse_value(
          entry,
          "is not below " + input::exact_text(most) +
              " (from 1 + 2 / Gruneisen on no shock brings the metal to its density); give solid "
              "over mean density"
      );
    if (body.initial_pressure != 0.0)
      deck.refuse_value(
          entry,
          "cannot be combined with a Confinement of the body (voids close at no pressure); remove "
          "one of the two"
      );
  }
}

void add_bodies(const Deck& deck, Scene& scene) {
  check_shapes(deck, scene.grid.mode);
  for (const std::string& name : deck.lists(table_of<BodySpec>().path)) {
    BodySpec& body = scene.bodies.emplace_back(read_body(deck, name, scene.grid));
    body.initial_pressure = own_pressure(scene.materials[static_cast<std::size_t>(body.material)]);
  }
}

void check_bodies(const Deck& deck, const Scene& scene) {
  for (const BodySpec& body : scene.bodies) check_filling(deck, scene, body);
  check_overlaps(deck, scene);
}

}  // namespace barreno
