// SPDX-License-Identifier: BSD-3-Clause
#include "scene/jet/jet_monitor.hpp"

#include "deck/section_table.hpp"
#include "scene/geometry.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <barreno/input/nearest_name.hpp>

namespace barreno {
namespace {

const BodySpec& body_at(const Scene& scene, int index) {
  return scene.bodies[static_cast<std::size_t>(index)];
}
const MaterialSpec& material_of(const Scene& scene, const BodySpec& body) {
  return scene.materials[static_cast<std::size_t>(body.material)];
}

int body_named(const Deck& deck, const Scene& scene, const std::string& name) {
  std::vector<std::string> names;
  for (const BodySpec& body : scene.bodies) names.push_back(body.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    deck.refuse_value(
        path_of(&JetMonitorSpec::body_names),
        "names '" + name + "', which is not in Bodies; " + input::suggest_name(name, names)
    );
  return static_cast<int>(found - names.begin());
}

/// Slugs of a table have one density, and a particle one id from one end to the other.
void read_bodies(const Deck& deck, const Scene& scene, JetMonitorSpec& monitor) {
  const std::string path = path_of(&JetMonitorSpec::body_names);
  for (const std::string& name : monitor.body_names) {
    const int index = body_named(deck, scene, name);
    const BodySpec& body = body_at(scene, index);
    const MaterialSpec& material = material_of(scene, body);
    if (material.detonation_speed())
      deck.refuse_value(
          path, "names '" + name + "', which is an explosive (its gas is no jet); name the liner"
      );
    if (material.splits() > 0)
      deck.refuse_value(
          path,
          "names '" + name +
              "', whose material has Splits (parts of a particle that has crossed would be counted "
              "again); remove Splits or the body"
      );
    if (!monitor.bodies.empty() && body.material != body_at(scene, monitor.bodies[0]).material)
      deck.refuse_value(
          path,
          "names bodies of different materials (a jet table is of one material); monitor one of "
          "them"
      );
    monitor.bodies.push_back(index);
    monitor.density = material.density();
  }
  if (monitor.bodies.empty())
    deck.refuse_value(path, "names no body (nothing would be monitored); name the liner");
}

void refuse_inside(
    const Deck& deck, const Scene& scene, const JetMonitorSpec& monitor, const BodySpec& body
) {
  const Box box = box_around(body.shape, scene.grid);
  const double front = monitor.direction > 0.0 ? box.upper[1] : box.lower[1];
  if (monitor.direction * (monitor.position - front) >= -length_tolerance(scene.grid)) return;
  deck.refuse_value(
      path_of(&JetMonitorSpec::position),
      "lies inside the charge or behind it (body '" + body.name +
          "' reaches beyond the plane, to y = " + text_of("%.6g", front) +
          " m, and what starts there crosses nothing); move the plane ahead of it"
  );
}

/// Ahead of the monitored bodies and of all explosive, inside the grid.
void check_plane(const Deck& deck, const Scene& scene, const JetMonitorSpec& monitor) {
  const std::string path = path_of(&JetMonitorSpec::position);
  if (monitor.position <= scene.grid.lower[1] || monitor.position >= scene.grid.upper[1])
    deck.refuse_value(
        path, "is outside the grid (nothing would cross the plane); move it between the two ends"
    );
  for (const int b : monitor.bodies) refuse_inside(deck, scene, monitor, body_at(scene, b));
  for (const BodySpec& body : scene.bodies)
    if (material_of(scene, body).detonation_speed()) refuse_inside(deck, scene, monitor, body);
}

/// Symmetry planes that contain the jet's axis x = z = 0 in three dimensions.
double copies_of(const Scene& scene) {
  if (scene.grid.mode != Mode::three_dimensional) return 1.0;
  double copies = 1.0;
  for (const ConditionSpec& condition : scene.conditions) {
    const auto face = static_cast<std::size_t>(condition.face);
    const std::size_t axis = face / 2;
    const double at = face % 2 == 0 ? scene.grid.lower[axis] : scene.grid.upper[axis];
    if (condition.kind == ConditionKind::symmetry && axis != 1 && at == 0.0) copies *= 2.0;
  }
  return copies;
}

}  // namespace

JetMonitorSpec jet_monitor_of(const Deck& deck, const Scene& scene) {
  if (!deck.has(path_of(&JetMonitorSpec::position)) &&
      !deck.has(path_of(&JetMonitorSpec::body_names)))
    return {};
  auto monitor = read_section<JetMonitorSpec>(deck);
  if (scene.grid.mode == Mode::plane_strain)
    deck.refuse(
        table_of<JetMonitorSpec>().path,
        "has no meaning in plane strain (slugs of a jet table are round); remove it"
    );
  read_bodies(deck, scene, monitor);
  check_plane(deck, scene, monitor);
  monitor.copies = copies_of(scene);
  return monitor;
}

}  // namespace barreno
