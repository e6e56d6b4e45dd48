// SPDX-License-Identifier: BSD-3-Clause
#include "deck/boundary_sections.hpp"
#include "scene/geometry.hpp"
#include "scene/load_tables.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

std::size_t axis_of(Face face) {
  return static_cast<std::size_t>(face) / 2;
}
bool is_upper(Face face) {
  return static_cast<int>(face) % 2 == 1;
}
double coordinate(const Box& box, Face face) {
  return (is_upper(face) ? box.upper : box.lower)[axis_of(face)];
}

std::vector<Face> faces_of(Mode mode) {
  std::vector<Face> faces;
  const int count = 2 * dimensions(mode);
  faces.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) faces.push_back(static_cast<Face>(i));
  return faces;
}

ConditionKind condition_kind(const std::string& word) {
  if (word == "symmetry") return ConditionKind::symmetry;
  return word == "fixed" ? ConditionKind::fixed : ConditionKind::prescribed_velocity;
}

const ConditionSpec* condition_on(const Scene& scene, Face face) {
  for (const ConditionSpec& condition : scene.conditions) {
    if (condition.face == face) return &condition;
  }
  return nullptr;
}

/// The axis is no boundary: matter cannot cross it, and must be free to move along it.
void check_axis(const Deck& deck, const Scene& scene) {
  if (scene.grid.mode != Mode::axisymmetric || scene.grid.lower[0] > 0.0) return;
  const ConditionSpec* condition = condition_on(scene, Face::x_lower);
  if (condition == nullptr) {
    deck.refuse(
        "Conditions",
        "has none on x_lower, which is the axis (nothing crosses it); add one of Kind symmetry"
    );
  }
  if (condition->kind != ConditionKind::symmetry) {
    deck.refuse_value(
        "Conditions/" + condition->name + "/Kind",
        "stands on x_lower, which is the axis (matter must be free to move along it); write "
        "symmetry"
    );
  }
}

/// A face of the grid that cuts a ball or a cone mirrors it.
void check_cut_bodies(const Deck& deck, const Scene& scene) {
  for (const BodySpec& body : scene.bodies) {
    const bool ball = std::holds_alternative<Ball>(body.shape);
    for (const Face face : cutting_faces(body.shape, scene.grid)) {
      const ConditionSpec* condition = condition_on(scene, face);
      if (condition != nullptr && condition->kind == ConditionKind::symmetry) continue;
      const std::string& name = face_names[static_cast<std::size_t>(face)];
      std::string problem = "lies on ";
      problem.append(name)
          .append(" of the grid, which cuts the ")
          .append(ball ? "ball" : "body")
          .append(" (its other part can only be a mirror image); ")
          .append("add a condition of Kind symmetry on ")
          .append(name)
          .append(" or enlarge Grid");
      deck.refuse_value("Bodies/" + body.name + (ball ? "/Centre" : "/Start"), problem);
    }
  }
}

/// How a face of one body lies on the opposite face of another.
enum class Sharing { none, part, whole };

Sharing sharing(const Box& a, Face face, const Box& b, std::size_t dimensions, double tolerance) {
  const auto opposite = static_cast<Face>(static_cast<int>(face) ^ 1);
  if (std::abs(coordinate(a, face) - coordinate(b, opposite)) > tolerance) return Sharing::none;
  bool whole = true;
  for (std::size_t along = 0; along < dimensions; ++along) {
    if (along == axis_of(face)) continue;
    if (std::min(a.upper[along], b.upper[along]) - std::max(a.lower[along], b.lower[along]) <=
        tolerance) {
      return Sharing::none;
    }
    whole = whole && b.lower[along] <= a.lower[along] + tolerance &&
            b.upper[along] >= a.upper[along] - tolerance;
  }
  return whole ? Sharing::whole : Sharing::part;
}

/// The face carries the confining pressure: no condition holds it and no confined body is behind
/// it.
bool is_outer(
    const Deck& deck, const Scene& scene, const std::vector<int>& confined, int body, Face face
) {
  const auto box_of = [&](int index) {
    return std::get<Box>(scene.bodies[static_cast<std::size_t>(index)].shape);
  };
  const auto count = static_cast<std::size_t>(dimensions(scene.grid.mode));
  const auto is_box = [&](int index) {
    return std::holds_alternative<Box>(scene.bodies[static_cast<std::size_t>(index)].shape);
  };
  const double tolerance = touching(scene.grid);
  const Box box = box_of(body), grid{scene.grid.lower, scene.grid.upper};
  const bool at_grid_face = std::abs(coordinate(box, face) - coordinate(grid, face)) <= tolerance;
  if (at_grid_face && condition_on(scene, face) != nullptr) return false;
  for (const int other : confined) {
    if (other == body || !is_box(other)) continue;  // a ball touches in a point
    const Sharing shared = sharing(box, face, box_of(other), count, tolerance);
    if (shared == Sharing::whole) return false;
    if (shared == Sharing::part) {
      deck.refuse_value(
          "Confinement/Bodies",
          "puts the pressure on a part of the face " + face_names[static_cast<std::size_t>(face)] +
              " of '" + scene.bodies[static_cast<std::size_t>(body)].name + "' ('" +
              scene.bodies[static_cast<std::size_t>(other)].name +
              "' covers the rest, and a face is pressed whole or not); make the faces equal or "
              "split the body"
      );
    }
  }
  return true;
}

}  // namespace

Face face_at(const Deck& deck, const std::string& path, const std::string& word, Mode mode) {
  const auto found = std::find(face_names.begin(), face_names.end(), word);
  const auto face = static_cast<Face>(found - face_names.begin());
  if (axis_of(face) >= static_cast<std::size_t>(dimensions(mode))) {
    deck.refuse_value(
        path,
        "names a face that does not exist in this mode (it has x and y only); choose one of those"
    );
  }
  return face;
}

void add_conditions(const Deck& deck, Scene& scene) {
  for (const std::string& name : deck.lists("Conditions")) {
    const std::string path = "Conditions/" + name;
    ConditionSpec condition;
    condition.name = name;
    condition.face = face_at(deck, path + "/Face", deck.word(path + "/Face"), scene.grid.mode);
    condition.kind = condition_kind(deck.word(path + "/Kind"));
    const bool prescribed = condition.kind == ConditionKind::prescribed_velocity;
    if (prescribed) {
      if (!deck.has(path + "/Velocity"))
        deck.refuse(path + "/Velocity", "is missing (a prescribed velocity needs it); add it");
      condition.velocity = vector_at(deck, path + "/Velocity", scene.grid.mode);
      condition.factor = read_factors(deck, path, "");
    } else {
      for (const char* entry : {"/Velocity", "/Times", "/Factors"})
        if (deck.has(path + entry))
          deck.refuse_value(
              path + entry, "has no meaning for this Kind; remove it or write prescribed velocity"
          );
    }
    if (const ConditionSpec* other = condition_on(scene, condition.face)) {
      deck.refuse_value(
          path + "/Face",
          "has the condition '" + other->name +
              "' already (a face moves in one way); remove one of them"
      );
    }
    scene.conditions.push_back(condition);
  }
  check_axis(deck, scene);
  check_cut_bodies(deck, scene);
}

namespace {

/// A body cannot start in equilibrium under a pressure that would crush or break it.
void check_holds(
    const Deck& deck, const Material& material, const std::string& body, double pressure
) {
  const bool possible = std::visit(
      [&](const auto& model) { return model.initial_state(pressure).possible; }, material.model
  );
  if (possible) return;
  deck.refuse_value(
      "Confinement/Pressure",
      "is more than '" + material.name + "' of Bodies/" + body +
          " can hold elastically (it could not start in equilibrium); lower the pressure or change "
          "the material"
  );
}

}  // namespace

namespace {

/// A face under the confining pressure that has a load of its own: a non-reflecting one takes the
/// pressure as its preload, any other would start out of equilibrium.
void preload(const Deck& deck, Scene& scene, int body, Face face, double pressure) {
  for (PressureLoadSpec& load : scene.loads) {
    if (load.body != body || !load.faces[static_cast<std::size_t>(face)]) continue;
    const bool absorbs = load.kind == LoadKind::non_reflecting;
    if (!absorbs || has_pressure(deck, "Loads/" + load.name)) {
      deck.refuse_value(
          "Confinement/Bodies",
          "presses a face of '" + scene.bodies[static_cast<std::size_t>(body)].name +
              "' that a load presses too (the body would not start in equilibrium); remove the " +
              (absorbs ? "load's pressure" : "load")
      );
    }
    load.pressure = {{0.0}, {pressure}};
  }
}

/// The surfaces of a ball, its hollow too, which would not be in equilibrium otherwise.
void confine_ball(const Deck& deck, const Scene& scene, const Ball& ball, PressureLoadSpec& load) {
  for (const BallSurface surface : {BallSurface::inner, BallSurface::outer}) {
    if (surface == BallSurface::inner && !(ball.inner_radius > 0.0)) continue;
    if (is_loaded(scene, load.body, surface)) {
      deck.refuse_value(
          "Confinement/Bodies",
          "presses a surface of '" + scene.bodies[static_cast<std::size_t>(load.body)].name +
              "' that a load presses too (the body would not start in equilibrium); remove the "
              "load"
      );
    }
    load.surfaces[static_cast<std::size_t>(surface)] = true;
  }
}

}  // namespace

void add_confinement(const Deck& deck, Scene& scene) {
  if (!deck.has("Confinement/Pressure")) return;
  const double pressure = deck.number("Confinement/Pressure");
  std::vector<int> confined;
  for (const std::string& name : deck.words("Confinement/Bodies")) {
    confined.push_back(body_named(deck, scene, "Confinement/Bodies", name));
  }
  for (const int body : confined) {
    BodySpec& spec = scene.bodies[static_cast<std::size_t>(body)];
    check_holds(
        deck, scene.materials[static_cast<std::size_t>(spec.material)].material, spec.name, pressure
    );
    spec.initial_pressure = pressure;
    PressureLoadSpec load;
    load.name = "Confinement of " + spec.name;
    load.body = body;
    load.pressure = {{0.0}, {pressure}};
    if (const auto* ball = std::get_if<Ball>(&spec.shape)) {
      confine_ball(deck, scene, *ball, load);
    } else {
      for (const Face face : faces_of(scene.grid.mode)) {
        if (!is_outer(deck, scene, confined, body, face)) continue;
        if (is_loaded(scene, body, face))
          preload(deck, scene, body, face, pressure);
        else
          load.faces[static_cast<std::size_t>(face)] = true;
      }
    }
    add_load(deck, "Confinement", load, scene);
  }
}

}  // namespace barreno
