// SPDX-License-Identifier: BSD-3-Clause
#include "scene/load_tables.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>

namespace barreno {
namespace {

LoadKind load_kind(const std::string& word) {
  if (word == "pressure") return LoadKind::pressure;
  return word == "pore fluid" ? LoadKind::pore_fluid : LoadKind::non_reflecting;
}

void refuse_foreign(
    const Deck& deck, const std::string& path, const char* entry, const std::string& why
) {
  if (deck.has(path + "/" + entry))
    deck.refuse_value(path + "/" + entry, "has no meaning for " + why + "; remove it");
}

void require(const Deck& deck, const std::string& path, const char* entry, const char* who) {
  if (!deck.has(path + "/" + entry))
    deck.refuse(path + "/" + entry, std::string("is missing (") + who + " needs it); add it");
}

/// Of every load on the surface so far; a second one would add to it unseen.
void check_once(const Deck& deck, const std::string& entry, const std::string& word, bool again) {
  if (again)
    deck.refuse_value(
        entry, "presses " + word + " of its body a second time; remove one of the loads"
    );
}

void read_faces(
    const Deck& deck, const Scene& scene, const std::string& path, PressureLoadSpec& load
) {
  refuse_foreign(deck, path, "Surfaces", "a box");
  require(deck, path, "Faces", "a load on a box");
  if (load.kind == LoadKind::pore_fluid)
    deck.refuse_value(
        path + "/Body", "names a box, which has no hollow for a pore fluid; choose a hollow ball"
    );
  for (const std::string& word : deck.words(path + "/Faces")) {
    const Face face = face_at(deck, path + "/Faces", word, scene.grid.mode);
    const auto index = static_cast<std::size_t>(face);
    check_once(deck, path + "/Faces", word, is_loaded(scene, load.body, face) || load.faces[index]);
    load.faces[index] = true;
  }
}

void read_surfaces(
    const Deck& deck,
    const Scene& scene,
    const std::string& path,
    const Ball& ball,
    PressureLoadSpec& load
) {
  refuse_foreign(deck, path, "Faces", "a ball");
  const bool fluid = load.kind == LoadKind::pore_fluid;
  if (load.kind == LoadKind::non_reflecting)
    deck.refuse_value(
        path + "/Body",
        "names a ball, but only the faces of boxes can be non-reflecting; choose a box"
    );
  if (fluid) refuse_foreign(deck, path, "Surfaces", "a pore fluid, which fills the hollow");
  if (!fluid) require(deck, path, "Surfaces", "a load on a ball");
  const std::string entry = path + (fluid ? "/Body" : "/Surfaces");
  const auto words = fluid ? std::vector<std::string>{"inner"} : deck.words(entry);
  for (const std::string& word : words) {
    const BallSurface surface = word == "inner" ? BallSurface::inner : BallSurface::outer;
    const auto index = static_cast<std::size_t>(surface);
    if (surface == BallSurface::inner && !(ball.inner_radius > 0.0))
      deck.refuse_value(entry, "means the hollow of a solid ball; give the ball an Inner Radius");
    check_once(deck, entry, word, is_loaded(scene, load.body, surface) || load.surfaces[index]);
    load.surfaces[index] = true;
  }
}

/// The pressure of the kind: a pore fluid starts with one, a non-reflecting face may have none or
/// that of the confinement.
void read_amount(const Deck& deck, const std::string& path, PressureLoadSpec& load) {
  if (load.kind != LoadKind::pore_fluid) {
    refuse_foreign(deck, path, "Bulk Modulus", "this Kind (it is a pore fluid's)");
    if (load.kind == LoadKind::pressure || has_pressure(deck, path))
      load.pressure = read_pressure(deck, path);
    return;
  }
  for (const char* entry : {"Times", "Pressures"})
    refuse_foreign(deck, path, entry, "a pore fluid, whose pressure follows from its volume");
  require(deck, path, "Bulk Modulus", "a pore fluid");
  load.bulk_modulus = deck.number(path + "/Bulk Modulus");
  if (has_pressure(deck, path)) load.pressure = {{0.0}, {deck.number(path + "/Pressure")}};
}

}  // namespace

bool is_loaded(const Scene& scene, int body, Face face) {
  return std::any_of(scene.loads.begin(), scene.loads.end(), [&](const PressureLoadSpec& load) {
    return load.body == body && load.faces[static_cast<std::size_t>(face)];
  });
}
bool is_loaded(const Scene& scene, int body, BallSurface surface) {
  return std::any_of(scene.loads.begin(), scene.loads.end(), [&](const PressureLoadSpec& load) {
    return load.body == body && load.surfaces[static_cast<std::size_t>(surface)];
  });
}

void add_load(
    const Deck& deck, const std::string& path, const PressureLoadSpec& load, Scene& scene
) {
  if (scene.loads.size() == most_loads)
    deck.refuse(
        path,
        "would be load number " + std::to_string(most_loads + 1) + ", but a scene has at most " +
            std::to_string(most_loads) +
            " (each confined body is one); name several faces in one load"
    );
  scene.loads.push_back(load);
}

void add_loads(const Deck& deck, Scene& scene) {
  for (const std::string& name : deck.lists("Loads")) {
    const std::string path = "Loads/" + name;
    PressureLoadSpec load;
    load.name = name;
    load.kind = load_kind(deck.word(path + "/Kind"));
    load.body = body_named(deck, scene, path + "/Body", deck.word(path + "/Body"));
    const Shape& shape = scene.bodies[static_cast<std::size_t>(load.body)].shape;
    if (const auto* ball = std::get_if<Ball>(&shape))
      read_surfaces(deck, scene, path, *ball, load);
    else
      read_faces(deck, scene, path, load);
    read_amount(deck, path, load);
    add_load(deck, path, load, scene);
  }
}

}  // namespace barreno
