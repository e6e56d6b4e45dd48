// SPDX-License-Identifier: BSD-3-Clause
#include "deck/section_table.hpp"
#include "scene/load_tables.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>

namespace barreno {
namespace {

void refuse_foreign(const Deck& deck, const std::string& path, const std::string& why) {
  if (deck.has(path)) deck.refuse_value(path, "has no meaning for " + why + "; remove it");
}

void require(const Deck& deck, const std::string& path, const char* who) {
  if (!deck.has(path)) deck.refuse(path, std::string("is missing (") + who + " needs it); add it");
}

/// Of every load on the surface so far; a second one would add to it unseen.
void check_once(const Deck& deck, const std::string& entry, const std::string& word, bool again) {
  if (again)
    deck.refuse_value(
        entry, "loads " + word + " of its body a second time; remove one of the loads"
    );
}

void read_faces(const Deck& deck, const Scene& scene, PressureLoadSpec& load) {
  const std::string entry = path_of(&PressureLoadSpec::faces, load.name);
  refuse_foreign(deck, path_of(&PressureLoadSpec::surfaces, load.name), "a box");
  require(deck, entry, "a load on a box");
  if (!traits_of(load.kind).on_faces)
    deck.refuse_value(
        path_of(&PressureLoadSpec::body, load.name),
        "names a box, which has no hollow for a pore fluid; choose a hollow ball"
    );
  for (const std::string& word : deck.words(entry)) {
    const Face face = face_at(deck, entry, word);
    const auto index = static_cast<std::size_t>(face);
    check_once(deck, entry, word, is_loaded(scene, load.body, face) || load.faces[index]);
    load.faces[index] = true;
  }
}

void read_surfaces(const Deck& deck, const Scene& scene, const Ball& ball, PressureLoadSpec& load) {
  const std::string body = path_of(&PressureLoadSpec::body, load.name);
  const std::string surfaces = path_of(&PressureLoadSpec::surfaces, load.name);
  refuse_foreign(deck, path_of(&PressureLoadSpec::faces, load.name), "a ball");
  const bool fluid = traits_of(load.kind).fills_hollow;
  if (!traits_of(load.kind).on_surfaces)
    deck.refuse_value(
        body, "names a ball, but only the faces of boxes can be non-reflecting; choose a box"
    );
  if (fluid) refuse_foreign(deck, surfaces, "a pore fluid, which fills the hollow");
  if (!fluid) require(deck, surfaces, "a load on a ball");
  const std::string& entry = fluid ? body : surfaces;
  const auto words = fluid ? std::vector{word_of(BallSurface::inner)} : deck.words(entry);
  for (const std::string& word : words) {
    const BallSurface surface =
        word == word_of(BallSurface::inner) ? BallSurface::inner : BallSurface::outer;
    const auto index = static_cast<std::size_t>(surface);
    if (surface == BallSurface::inner && !(ball.inner_radius > 0.0))
      deck.refuse_value(
          entry, "means the inner surface of a solid ball; give the ball an Inner Radius"
      );
    check_once(deck, entry, word, is_loaded(scene, load.body, surface) || load.surfaces[index]);
    load.surfaces[index] = true;
  }
}

/// The pressure of the kind: a pore fluid starts with one, a non-reflecting face may have none or
/// that of the confinement.
void read_amount(const Deck& deck, const std::string& path, PressureLoadSpec& load) {
  const std::string modulus = path_of(&PressureLoadSpec::bulk_modulus, load.name);
  if (!traits_of(load.kind).fills_hollow) {
    refuse_foreign(deck, modulus, "this Kind (it is a pore fluid's)");
    if (!traits_of(load.kind).preload || has_pressure(deck, path))
      load.pressure = read_pressure(deck, path);
    return;
  }
  for (const char* entry : {times_word, pressures_word})
    refuse_foreign(
        deck, input::join(path, entry), "a pore fluid, whose pressure follows from its volume"
    );
  require(deck, modulus, "a pore fluid");
  const std::string pressure = path_of(&PressureLoadSpec::pressure, load.name);
  if (deck.has(pressure)) load.pressure = {{0.0}, {deck.number(pressure)}};
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

void add_loads(const Deck& deck, Scene& scene) {
  for (const std::string& name : deck.lists(table_of<PressureLoadSpec>().path)) {
    const std::string path = list_of<PressureLoadSpec>(name);
    const std::string body = path_of(&PressureLoadSpec::body, name);
    auto load = read_list<PressureLoadSpec>(deck, path);
    load.name = name;
    load.body = body_named(deck, scene, body, deck.word(body));
    const Shape& shape = scene.bodies[static_cast<std::size_t>(load.body)].shape;
    if (const auto* ball = std::get_if<Ball>(&shape))
      read_surfaces(deck, scene, *ball, load);
    else
      read_faces(deck, scene, load);
    read_amount(deck, path, load);
    scene.loads.push_back(load);
  }
}

}  // namespace barreno
