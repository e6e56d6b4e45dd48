// SPDX-License-Identifier: BSD-3-Clause
#include "scene/geometry.hpp"
#include "scene/porous.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <barreno/input/nearest_name.hpp>
#include <barreno/input/scan_xml.hpp>
#include <limits>

namespace barreno {
namespace {

/// The radial field is infinite at the centre: only a hollow ball can have it.
void read_radial_velocity(const Deck& deck, const std::string& path, BodySpec& body) {
  const std::string entry = path + "/Radial Velocity";
  if (!deck.has(entry)) return;
  const auto* ball = std::get_if<Ball>(&body.shape);
  if (ball == nullptr || ball->inner_radius == 0.0) {
    deck.refuse_value(
        entry,
        "has no meaning without Inner Radius (it is the velocity of a hollow ball's inner "
        "surface); "
        "remove it or make the body a ball with Inner Radius"
    );
  }
  if (deck.has(path + "/Velocity Wave Number")) {
    deck.refuse_value(
        entry,
        "cannot be joined with Velocity Wave Number (two fields of velocity); remove one of the two"
    );
  }
  body.radial_velocity = deck.number(entry);
}

/// A ring that spins about the axis would need a velocity out of the plane.
void read_spin(const Deck& deck, const std::string& path, Mode mode, BodySpec& body) {
  const std::string entry = path + "/Spin";
  if (!deck.has(entry)) return;
  if (mode == Mode::axisymmetric)
    deck.refuse_value(
        entry, "has no meaning in axisymmetry (nothing moves around the axis); remove it"
    );
  if (!std::holds_alternative<Box>(body.shape) && !std::holds_alternative<Ball>(body.shape)) {
    deck.refuse_value(
        entry,
        "has no meaning for a " + deck.word(path + "/Shape") +
            " (only boxes and balls have a middle to turn about); remove it or change Shape"
    );
  }
  body.spin = deck.number(entry);
}

BodySpec read_body(const Deck& deck, const std::string& name, const GridSpec& grid) {
  const std::string path = "Bodies/" + name;
  BodySpec body;
  body.name = name;
  body.material = material_at(deck, path + "/Material");
  body.shape = read_shape(deck, path, grid.mode);
  body.particles_per_cell = deck.integer(path + "/Particles Per Cell");
  if (deck.has(path + "/Velocity")) body.velocity = vector_at(deck, path + "/Velocity", grid.mode);
  if (deck.has(path + "/Velocity Wave Number")) {
    body.velocity_wave_number = vector_at(deck, path + "/Velocity Wave Number", grid.mode);
  }
  read_radial_velocity(deck, path, body);
  read_spin(deck, path, grid.mode, body);
  if (deck.has(path + "/Pore Pressure")) body.pore_pressure = deck.number(path + "/Pore Pressure");
  body.motion = read_motion(deck, path, grid.mode);
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
  const std::string path = "Bodies/" + body.name;
  const double size = scene.grid.cell_size / body.particles_per_cell;
  const Filling filling =
      filling_of(body.shape, dimensions(scene.grid.mode), lattice_of(body.shape, scene.grid, size));
  if (filling.cells == 0) {
    deck.refuse(
        path, "is empty (no place in the grid belongs to it); change its shape or its parts"
    );
  }
  constexpr double least_filled = 0.5;
  if (thickness_of(body.shape) < size || filling.fullest < least_filled) {
    deck.refuse(
        path,
        "is thinner than a particle, which is " + input::exact_text(size) +
            " m wide (its stress could not be told); make cells smaller, Particles Per Cell larger "
            "or the body thicker"
    );
  }
}

}  // namespace

Vector vector_at(const Deck& deck, const std::string& path, Mode mode) {
  const auto values = deck.vector(path);
  const auto count = static_cast<std::size_t>(dimensions(mode));
  if (values.size() != count) {
    const char* axes = mode == Mode::axisymmetric   ? "{r, axial}"
                       : mode == Mode::plane_strain ? "{x, y}"
                                                    : "{x, y, z}";
    deck.refuse_value(
        path,
        "has " + std::to_string(values.size()) + " components (this mode has " +
            std::to_string(count) + "); write " + axes
    );
  }
  Vector vector{};
  std::copy(values.begin(), values.end(), vector.begin());
  return vector;
}

int material_at(const Deck& deck, const std::string& path) {
  const auto names = deck.lists("Materials");
  const std::string name = deck.word(path);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    deck.refuse_value(path, "names no list in Materials; " + input::suggest_name(name, names));
  }
  return static_cast<int>(found - names.begin());
}

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
        "names '" + name + "', which is a " + deck.word("Bodies/" + name + "/Shape") +
            " (only boxes and balls have surfaces to press); choose one of those"
    );
  }
  return static_cast<int>(index);
}

void check_pore_pressures(const Deck& deck, const Scene& scene) {
  for (const BodySpec& body : scene.bodies) {
    if (!body.pore_pressure) continue;
    const Material& material = scene.materials[static_cast<std::size_t>(body.material)].material;
    const bool possible = std::visit(
        [&](const auto& model) { return initial_state_of(model, body).possible; }, material.model
    );
    if (!possible)
      deck.refuse_value(
          "Bodies/" + body.name + "/Pore Pressure",
          "is nothing that '" + material.name +
              "' can start with (Arenisca needs fluid_B0 and a Confinement of at least that, "
              "Poroelastic a Fluid Bulk Modulus); remove it or change one of them"
      );
  }
}

void add_bodies(const Deck& deck, Scene& scene) {
  check_shapes(deck, scene.grid.mode);
  for (const std::string& name : deck.lists("Bodies"))
    scene.bodies.push_back(read_body(deck, name, scene.grid));
}

void check_bodies(const Deck& deck, const Scene& scene) {
  for (const BodySpec& body : scene.bodies) check_filling(deck, scene, body);
  check_apart(deck, scene);
}

}  // namespace barreno
