// SPDX-License-Identifier: BSD-3-Clause
#include "deck/section_table.hpp"
#include "geometry/piece.hpp"
#include "scene/geometry.hpp"
#include "scene/lighting.hpp"
#include "scene/lighting_map.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <barreno/input/nearest_name.hpp>
#include <cmath>

namespace barreno {
namespace {

int explosive_named(const Deck& deck, const Scene& scene, const std::string& name) {
  const std::string path = path_of(&DetonationSpec::body_names);
  std::vector<std::string> names;
  for (const BodySpec& body : scene.bodies) names.push_back(body.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    deck.refuse_value(
        path, "names '" + name + "', which is not in Bodies; " + input::suggest_name(name, names)
    );
  const auto index = found - names.begin();
  if (!is_explosive(scene, scene.bodies[static_cast<std::size_t>(index)]))
    deck.refuse_value(
        path,
        "names '" + name +
            "', which is no explosive (its material does not burn); remove it or give the body a "
            "material of the model JWL Explosive"
    );
  return static_cast<int>(index);
}

/// Of one explosive, because there is one speed.
void read_bodies(const Deck& deck, Scene& scene) {
  DetonationSpec& detonation = scene.detonation;
  for (const std::string& name : detonation.body_names) {
    const int index = explosive_named(deck, scene, name);
    const BodySpec& body = scene.bodies[static_cast<std::size_t>(index)];
    const MaterialSpec& material = scene.materials[static_cast<std::size_t>(body.material)];
    const double speed = *material.detonation_speed();
    if (!detonation.bodies.empty() && speed != detonation.speed)
      deck.refuse_value(
          path_of(&DetonationSpec::body_names),
          "names bodies whose explosives have different Detonation Speeds (one front has one "
          "speed); give them one material"
      );
    detonation.speed = speed;
    detonation.bodies.push_back(index);
  }
}

void refuse_unlit(const Deck& deck, const Scene& scene) {
  const std::vector<int>& lit = scene.detonation.bodies;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const BodySpec& body = scene.bodies[b];
    if (!is_explosive(scene, body) ||
        std::find(lit.begin(), lit.end(), static_cast<int>(b)) != lit.end())
      continue;
    deck.refuse(
        list_of<BodySpec>(body.name),
        "is an explosive that nothing lights (it would lie there as dead weight); name it in "
        "Detonation/Bodies, with a detonator"
    );
  }
  if (scene.jet.present &&
      scene.materials[static_cast<std::size_t>(scene.jet.material)].detonation_speed())
    deck.refuse_value(
        path_of(&JetSpec::material),
        "is an explosive, which nothing would light in a jet; choose a metal"
    );
}

void refuse_foreign(const Deck& deck, const std::string& path, DetonatorKind kind) {
  if (deck.has(path))
    deck.refuse_value(path, "has no meaning for a " + word_of(kind) + "; remove it");
}
void require(const Deck& deck, const std::string& path, DetonatorKind kind) {
  if (!deck.has(path)) deck.refuse(path, "is missing (a " + word_of(kind) + " needs it); add it");
}

/// What a detonator of its kind has, and no other.
void check_entries(const Deck& deck, Mode mode, const DetonatorSpec& detonator) {
  const DetonatorKind kind = detonator.kind;
  const bool flat_ring = kind == DetonatorKind::ring && mode == Mode::axisymmetric;
  const auto check = [&](const std::string& path, bool has_it) {
    has_it ? require(deck, path, kind) : refuse_foreign(deck, path, kind);
  };
  check(path_of(&DetonatorSpec::end, detonator.name), kind == DetonatorKind::line);
  check(
      path_of(&DetonatorSpec::normal, detonator.name),
      kind == DetonatorKind::plane || (kind == DetonatorKind::ring && !flat_ring)
  );
  check(path_of(&DetonatorSpec::radius, detonator.name), kind == DetonatorKind::ring);
  if (kind == DetonatorKind::ring && mode == Mode::plane_strain)
    deck.refuse_value(
        path_of(&DetonatorSpec::kind, detonator.name),
        "has no meaning in plane strain (a ring goes through the plane at two points); give two "
        "points"
    );
  if (flat_ring && detonator.position[0] != 0.0)
    deck.refuse_value(
        path_of(&DetonatorSpec::position, detonator.name),
        "is not on the axis, about which the ring lies (in axisymmetry no other can be); give it x "
        "= 0"
    );
  if (kind == DetonatorKind::line && detonator.end == detonator.position)
    deck.refuse_value(
        path_of(&DetonatorSpec::end, detonator.name),
        "is its Position too (the line has no length); move it or make the detonator a point"
    );
}

/// To the length 1.
void settle_normal(const Deck& deck, DetonatorSpec& detonator) {
  const std::string path = path_of(&DetonatorSpec::normal, detonator.name);
  if (!deck.has(path)) return;
  Vector& n = detonator.normal;
  const double length = length_of(n);
  if (length == 0.0)
    deck.refuse_value(path, "has no direction (all its components are 0); give it one");
  for (double& component : n) component /= length;
}

/// In one of the bodies or on its surface.
bool is_inside(const Scene& scene, const Vector& x) {
  const int dimension = dimensions(scene.grid.mode);
  const double near = length_tolerance(scene.grid);
  Box around{x, x};
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d) {
    around.lower[d] -= near;
    around.upper[d] += near;
  }
  const std::vector<int>& bodies = scene.detonation.bodies;
  return std::any_of(bodies.begin(), bodies.end(), [&](int b) {
    const Shape& shape = scene.bodies[static_cast<std::size_t>(b)].shape;
    return piece_of(shape, around, dimension).measure > 0.0;
  });
}

/// Points of a detonator that must be in the explosive, with the entries that say them.
void check_inside(const Deck& deck, const Scene& scene, const DetonatorSpec& detonator) {
  const auto check = [&](const Vector& x, const std::string& path) {
    if (is_inside(scene, x)) return;
    deck.refuse_value(
        path,
        "is outside the bodies of Detonation (it would light nothing); move the detonator into one "
        "of them"
    );
  };
  if (detonator.kind == DetonatorKind::ring) {
    Vector far = detonator.position;
    for (std::size_t d = 0; d < 3; ++d) far[d] += 1e3 * detonator.radius * (d == 0 ? 1.0 : 0.01);
    check(
        nearest_point(detonator, scene.grid.mode, far),
        path_of(&DetonatorSpec::radius, detonator.name)
    );
    return;
  }
  check(detonator.position, path_of(&DetonatorSpec::position, detonator.name));
  if (detonator.kind == DetonatorKind::line)
    check(detonator.end, path_of(&DetonatorSpec::end, detonator.name));
}

void read_detonators(const Deck& deck, Scene& scene) {
  const std::string& section = table_of<DetonatorSpec>().path;
  for (const std::string& name : deck.lists(section)) {
    auto detonator = read_list<DetonatorSpec>(deck, list_of<DetonatorSpec>(name));
    detonator.name = name;
    check_entries(deck, scene.grid.mode, detonator);
    settle_normal(deck, detonator);
    check_inside(deck, scene, detonator);
    scene.detonation.detonators.push_back(detonator);
  }
  if (scene.detonation.detonators.empty())
    deck.refuse(section, "has no detonator (nothing would light the explosive); add one");
}

/// The way around obstacles, and whether it leads everywhere.
void map_lighting(const Deck& deck, Scene& scene) {
  DetonationSpec& detonation = scene.detonation;
  if (detonation.lighting != Lighting::around_obstacles) return;
  std::vector<Shape> shapes;
  for (const int b : detonation.bodies)
    shapes.push_back(scene.bodies[static_cast<std::size_t>(b)].shape);
  const auto map = std::make_shared<const LightingMap>(scene.grid, shapes, detonation);
  if (!map->reaches_all())
    deck.refuse_value(
        path_of(&DetonationSpec::lighting),
        "leaves a part of the explosive unlit (no detonator's front comes there through Bodies); "
        "add a detonator to that part, make cells smaller than what connects it, or write straight"
    );
  detonation.map = map;
}

}  // namespace

void add_detonation(const Deck& deck, Scene& scene) {
  if (deck.has(path_of(&DetonationSpec::body_names))) {
    scene.detonation = read_section<DetonationSpec>(deck);
    read_bodies(deck, scene);
    read_detonators(deck, scene);
    map_lighting(deck, scene);
  }
  refuse_unlit(deck, scene);
}

}  // namespace barreno
