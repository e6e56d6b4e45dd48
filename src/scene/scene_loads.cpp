// SPDX-License-Identifier: BSD-3-Clause
#include "deck/section_table.hpp"
#include "deck/sections/shape_section.hpp"
#include "scene/geometry.hpp"
#include "scene/load_tables.hpp"
#include "scene/materials/liquids.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <barreno/models.hpp>
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

const ConditionSpec* condition_on(const Scene& scene, Face face) {
  for (const ConditionSpec& condition : scene.conditions) {
    if (condition.face == face) return &condition;
  }
  return nullptr;
}

/// The axis is not a boundary: matter cannot cross it, and must be free to move along it.
void check_axis(const Deck& deck, const Scene& scene) {
  if (scene.grid.mode != Mode::axisymmetric || scene.grid.lower[0] > 0.0) return;
  const ConditionSpec* condition = condition_on(scene, Face::x_lower);
  if (condition == nullptr) {
    deck.refuse(
        table_of<ConditionSpec>().path,
        "has no condition on x_lower, which is the axis (nothing may cross it); add one of Kind "
        "symmetry"
    );
  }
  if (condition->kind != ConditionKind::symmetry) {
    deck.refuse_value(
        path_of(&ConditionSpec::kind, condition->name),
        "is set on x_lower, which is the axis (material must be free to move along it); write "
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
      const std::string name = word_of(face);
      std::string problem = "lies on ";
      problem.append(name)
          .append(" of the grid, which cuts the ")
          .append(ball ? "ball" : "body")
          .append(" (the part cut off can only be a mirror image); ")
          .append("add a condition of Kind symmetry on ")
          .append(name)
          .append(" or enlarge Grid");
      const std::string& entry = name_of(ball ? &ShapeSection::centre : &ShapeSection::start);
      deck.refuse_value(input::join(list_of<BodySpec>(body.name), entry), problem);
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
  const double tolerance = length_tolerance(scene.grid);
  const Box box = box_of(body), grid{scene.grid.lower, scene.grid.upper};
  const bool at_grid_face = std::abs(coordinate(box, face) - coordinate(grid, face)) <= tolerance;
  if (at_grid_face && condition_on(scene, face) != nullptr) return false;
  for (const int other : confined) {
    if (other == body || !is_box(other)) continue;  // a ball touches in a point
    const Sharing shared = sharing(box, face, box_of(other), count, tolerance);
    if (shared == Sharing::whole) return false;
    if (shared == Sharing::part) {
      deck.refuse_value(
          path_of(&ConfinementSection::bodies),
          "puts the pressure on only part of the face " + word_of(face) + " of '" +
              scene.bodies[static_cast<std::size_t>(body)].name + "' ('" +
              scene.bodies[static_cast<std::size_t>(other)].name +
              "' covers the rest, but a face is loaded as a whole or not at all); make the faces "
              "equal or split the body"
      );
    }
  }
  return true;
}

}  // namespace

void add_conditions(const Deck& deck, Scene& scene) {
  for (const std::string& name : deck.lists(table_of<ConditionSpec>().path)) {
    const std::string path = list_of<ConditionSpec>(name);
    auto condition = read_list<ConditionSpec>(deck, path);
    condition.name = name;
    const std::string velocity = path_of(&ConditionSpec::velocity, name);
    if (traits_of(condition.kind).moves) {
      if (!deck.has(velocity))
        deck.refuse(velocity, "is missing (a " + word_of(condition.kind) + " needs it); add it");
      condition.factor = read_factors(deck, path, "");
    } else {
      for (const std::string& entry :
           {velocity, input::join(path, times_word), input::join(path, factors_word)})
        if (deck.has(entry))
          deck.refuse_value(
              entry, "has no meaning for this Kind; remove it or write prescribed velocity"
          );
    }
    if (const ConditionSpec* other = condition_on(scene, condition.face)) {
      deck.refuse_value(
          path_of(&ConditionSpec::face, name),
          "has the condition '" + other->name +
              "' already (a face can have only one); remove one of them"
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
      path_of(&ConfinementSection::pressure),
      "is more than '" + material.name + "' of " + list_of<BodySpec>(body) +
          " can hold elastically (it could not start in equilibrium); lower the pressure or change "
          "the material"
  );
}

/// A liquid starts under the confining pressure, if its own says nothing else.
void check_same_pressure(
    const Deck& deck, const Scene& scene, const BodySpec& body, double pressure
) {
  const MaterialSpec& material = scene.materials[static_cast<std::size_t>(body.material)];
  const double own = own_pressure(material);
  if (own == 0.0 || own == pressure) return;
  deck.refuse_value(
      path_of(&ConfinementSection::pressure),
      "is not the Initial Pressure " + input::exact_text(own) + " Pa of '" + material.name() +
          "' in " + list_of<BodySpec>(body.name) +
          " (the liquid would not start in equilibrium); remove Initial Pressure, or the body from "
          "Confinement/Bodies"
  );
}

}  // namespace

namespace {

/// A face under the confining pressure that has a load of its own: a non-reflecting one takes the
/// pressure as its preload, any other would start out of equilibrium.
void preload(const Deck& deck, Scene& scene, int body, Face face, double pressure) {
  for (PressureLoadSpec& load : scene.loads) {
    if (load.body != body || !load.faces[static_cast<std::size_t>(face)]) continue;
    const bool may_have_one = traits_of(load.kind).preload;
    if (!may_have_one || has_pressure(deck, list_of<PressureLoadSpec>(load.name))) {
      deck.refuse_value(
          path_of(&ConfinementSection::bodies),
          "acts on a face of '" + scene.bodies[static_cast<std::size_t>(body)].name +
              "' that another load acts on (the body would not start in equilibrium); remove the " +
              (may_have_one ? "load's pressure" : "load")
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
          path_of(&ConfinementSection::bodies),
          "acts on a surface of '" + scene.bodies[static_cast<std::size_t>(load.body)].name +
              "' that another load acts on (the body would not start in equilibrium); remove the "
              "load"
      );
    }
    load.surfaces[static_cast<std::size_t>(surface)] = true;
  }
}

}  // namespace

void add_confinement(const Deck& deck, Scene& scene) {
  if (!deck.has(path_of(&ConfinementSection::pressure))) return;
  const auto said = read_section<ConfinementSection>(deck);
  const double pressure = said.pressure;
  std::vector<int> confined;
  for (const std::string& name : said.bodies) {
    confined.push_back(body_named(deck, scene, path_of(&ConfinementSection::bodies), name));
  }
  for (const int body : confined) {
    BodySpec& spec = scene.bodies[static_cast<std::size_t>(body)];
    check_same_pressure(deck, scene, spec, pressure);
    check_holds(
        deck,
        scene.materials[static_cast<std::size_t>(spec.material)].material(),
        spec.name,
        pressure
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
    scene.loads.push_back(load);
  }
}

}  // namespace barreno
