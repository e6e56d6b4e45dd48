// SPDX-License-Identifier: BSD-3-Clause
#include "scene/geometry.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <barreno/input/nearest_name.hpp>

namespace barreno {
namespace {

/// Refuse a parameter of the other shape, which would be read and do nothing.
void check_shape_entries(
    const Deck& deck,
    const std::string& path,
    const std::string& shape,
    const std::vector<const char*>& needed,
    const std::vector<const char*>& foreign
) {
  for (const char* name : needed) {
    if (!deck.has(path + "/" + name)) {
      deck.refuse(
          path + "/" + name, "is missing (a " + shape + " needs it); add it or change Shape"
      );
    }
  }
  for (const char* name : foreign) {
    if (deck.has(path + "/" + name)) {
      deck.refuse_value(
          path + "/" + name, "has no meaning for a " + shape + "; remove it or change Shape"
      );
    }
  }
}

Box read_box(const Deck& deck, const std::string& path, Mode mode) {
  check_shape_entries(deck, path, "box", {"Lower", "Upper"}, {"Centre", "Radius", "Inner Radius"});
  const Box box{vector_at(deck, path + "/Lower", mode), vector_at(deck, path + "/Upper", mode)};
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions(mode)); ++i) {
    if (!(box.upper[i] > box.lower[i])) {
      deck.refuse_value(
          path + "/Upper",
          std::string("is not above Lower along ") + "xyz"[i] +
              " (the body is empty); exchange the two"
      );
    }
  }
  return box;
}

Ball read_ball(const Deck& deck, const std::string& path, Mode mode) {
  if (mode == Mode::three_dimensional) {
    deck.refuse_value(
        path + "/Shape",
        "cannot be filled in three dimensions (only boxes can); write box or change Grid/Mode"
    );
  }
  check_shape_entries(deck, path, "ball", {"Centre", "Radius"}, {"Lower", "Upper"});
  Ball ball{vector_at(deck, path + "/Centre", mode), deck.number(path + "/Radius")};
  if (deck.has(path + "/Inner Radius")) ball.inner_radius = deck.number(path + "/Inner Radius");
  if (!(ball.inner_radius < ball.radius)) {
    deck.refuse_value(
        path + "/Inner Radius", "is not below Radius (the body is empty); make it smaller"
    );
  }
  if (mode == Mode::axisymmetric && ball.centre[0] != 0.0) {
    deck.refuse_value(
        path + "/Centre", "is off the axis (the ball would be a ring); put it at x = 0"
    );
  }
  return ball;
}

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
  body.spin = deck.number(entry);
}

BodySpec read_body(const Deck& deck, const std::string& name, const GridSpec& grid) {
  const std::string path = "Bodies/" + name;
  BodySpec body;
  body.name = name;
  body.material = material_at(deck, path + "/Material");
  if (deck.word(path + "/Shape") == "box") {
    body.shape = read_box(deck, path, grid.mode);
  } else {
    body.shape = read_ball(deck, path, grid.mode);
  }
  body.particles_per_cell = deck.integer(path + "/Particles Per Cell");
  if (deck.has(path + "/Velocity")) body.velocity = vector_at(deck, path + "/Velocity", grid.mode);
  if (deck.has(path + "/Velocity Wave Number")) {
    body.velocity_wave_number = vector_at(deck, path + "/Velocity Wave Number", grid.mode);
  }
  read_radial_velocity(deck, path, body);
  read_spin(deck, path, grid.mode, body);
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
  if (!std::holds_alternative<Box>(scene.bodies[index].shape)) {
    deck.refuse_value(
        path, "names '" + name + "', which is a ball (only boxes have faces to press); choose a box"
    );
  }
  return static_cast<int>(index);
}

void add_bodies(const Deck& deck, Scene& scene) {
  for (const std::string& name : deck.lists("Bodies")) {
    const BodySpec body = read_body(deck, name, scene.grid);
    for (const BodySpec& other : scene.bodies) {
      if (overlap(body.shape, other.shape, scene.grid)) {
        deck.refuse(
            "Bodies/" + name,
            "overlaps Bodies/" + other.name +
                " (the same place would be filled twice); move or shrink one of them"
        );
      }
    }
    scene.bodies.push_back(body);
  }
}

}  // namespace barreno
