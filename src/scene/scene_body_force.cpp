// SPDX-License-Identifier: BSD-3-Clause
#include "deck/section_table.hpp"
#include "scene/scene_parts.hpp"

#include <barreno/models.hpp>
#include <cmath>

namespace barreno {
namespace {

/// The one entry that a kind needs; the others would be read and do nothing.
void check_entries(const Deck& deck, const std::string& kind, const std::string& needed) {
  for (const std::string& path :
       {path_of(&BodyForceSpec::acceleration),
        path_of(&BodyForceSpec::amplitude),
        path_of(&BodyForceSpec::angle)}) {
    if (path == needed && !deck.has(path))
      deck.refuse(path, "is missing (the kind '" + kind + "' needs it); add it or change Kind");
    if (path != needed && deck.has(path))
      deck.refuse_value(
          path, "has no meaning for the kind '" + kind + "'; remove it or change Kind"
      );
  }
}

void check_gravity(const Deck& deck, const Scene& scene) {
  if (scene.grid.mode == Mode::axisymmetric && scene.body_force.acceleration[0] != 0.0)
    deck.refuse_value(
        path_of(&BodyForceSpec::acceleration),
        "has a radial component (no such field is axisymmetric); write {0 m/s2, ...}"
    );
}

void read_solid(const Deck& deck, Scene& scene) {
  BodyForceSpec& spec = scene.body_force;
  const std::string path = path_of(&BodyForceSpec::kind);
  if (scene.bodies.size() != 1 || scene.jet.present)
    deck.refuse_value(path, "moves one body alone; leave one in Bodies and no Jet");
  const Material& material =
      scene.materials[static_cast<std::size_t>(scene.bodies[0].material)].material();
  const auto* solid = std::get_if<NeoHookean>(&material.model);
  if (solid == nullptr)
    deck.refuse_value(
        path,
        "is derived for a Neo-Hookean material (the body force contains its stress); change the "
        "Model"
    );
  spec.density = material.density;
  spec.lambda = solid->lambda();
  spec.shear = solid->parameters().shear_modulus;
  spec.young = spec.shear * (3.0 * spec.lambda + 2.0 * spec.shear) / (spec.lambda + spec.shear);
}

void check_unit_box(const Deck& deck, const Scene& scene) {
  const auto* box = std::get_if<Box>(&scene.bodies[0].shape);
  bool unit = box != nullptr;
  for (std::size_t i = 0; unit && i < static_cast<std::size_t>(scene.body_force.dimensions); ++i)
    unit = box->lower[i] == 0.0 && box->upper[i] == 1.0;
  if (!unit)
    deck.refuse(
        list_of<BodySpec>(scene.bodies[0].name),
        "is not the box from 0 to 1 m (on which the displacement is defined); give it these corners"
    );
}

void read_disk(const Deck& deck, Scene& scene) {
  BodyForceSpec& spec = scene.body_force;
  const auto* ball = std::get_if<Ball>(&scene.bodies[0].shape);
  const std::string path = list_of<BodySpec>(scene.bodies[0].name);
  if (ball == nullptr || ball->inner_radius == 0.0 || scene.grid.mode != Mode::plane_strain)
    deck.refuse(
        path,
        "is not a hollow disk (this Body Force rotates or expands one); make it a ball with Inner "
        "Radius in plane strain"
    );
  spec.centre = ball->centre;
  spec.inner_radius = ball->inner_radius;
  spec.outer_radius = ball->radius;
  if (spec.kind == BodyForceKind::vortex && (spec.inner_radius < 0.75 || spec.outer_radius > 1.25))
    deck.refuse(
        path,
        "reaches beyond radii of 0.75 m and 1.25 m (the vortex is defined on the ring between "
        "them); make it smaller"
    );
  if (spec.kind != BodyForceKind::ring) return;
  if (std::abs(spec.outer_radius - 3.0 * spec.inner_radius) < 1e-6 * spec.outer_radius)
    deck.refuse(
        path,
        "has an outer radius of three times the inner one (the expanding ring has no solution "
        "there); change one of them"
    );
  if (spec.lambda > 1e-6 * spec.shear)
    deck.refuse_value(
        path_of(&BodyForceSpec::kind),
        "is derived for a material without lateral strain; write Bulk Modulus = 2/3 Shear Modulus"
    );
}

}  // namespace

void add_body_force(const Deck& deck, Scene& scene) {
  if (!deck.has(path_of(&BodyForceSpec::kind))) return;
  BodyForceSpec& spec = scene.body_force;
  spec = read_section<BodyForceSpec>(deck);
  spec.dimensions = dimensions(scene.grid.mode);
  spec.axisymmetric = scene.grid.mode == Mode::axisymmetric;
  const std::string word = word_of(spec.kind);
  if (spec.kind == BodyForceKind::gravity) {
    check_entries(deck, word, path_of(&BodyForceSpec::acceleration));
    check_gravity(deck, scene);
    return;
  }
  const bool vortex = spec.kind == BodyForceKind::vortex;
  check_entries(deck, word, path_of(vortex ? &BodyForceSpec::angle : &BodyForceSpec::amplitude));
  if (vortex) spec.amplitude = spec.angle;
  read_solid(deck, scene);
  if (spec.kind == BodyForceKind::axis_aligned)
    check_unit_box(deck, scene);
  else
    read_disk(deck, scene);
}

}  // namespace barreno
