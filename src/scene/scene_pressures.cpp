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

void require(const Deck& deck, const std::string& path, const std::string& who) {
  if (!deck.has(path)) deck.refuse(path, "is missing (" + who + " needs it); add it");
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
  if (const char* why = traits_of(load.kind).why_no_box)
    deck.refuse_value(path_of(&PressureLoadSpec::body, load.name), why);
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
  const LoadTraits& traits = traits_of(load.kind);
  const bool fluid = traits.fills_hollow;
  if (traits.why_no_ball != nullptr) deck.refuse_value(body, traits.why_no_ball);
  if (traits.no_surfaces != nullptr) refuse_foreign(deck, surfaces, traits.no_surfaces);
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

/// "a pore fluid": the kind that fills hollows.
std::string filling_kind() {
  for (const LoadTraits& traits : load_traits)
    if (traits.fills_hollow) return std::string("a ") + traits.word;
  return {};
}

/// The pressure of the kind: a fluid starts with one, a load that may be a preload needs none.
void read_amount(const Deck& deck, const std::string& path, PressureLoadSpec& load) {
  const std::string modulus = path_of(&PressureLoadSpec::bulk_modulus, load.name);
  const LoadTraits& traits = traits_of(load.kind);
  if (traits.no_times != nullptr)
    for (const char* entry : {times_word, pressures_word})
      refuse_foreign(deck, input::join(path, entry), traits.no_times);
  if (!traits.fills_hollow) {
    refuse_foreign(deck, modulus, "this Kind (it is " + filling_kind() + "'s)");
    if (!traits.preload || has_pressure(deck, path)) load.pressure = read_pressure(deck, path);
    return;
  }
  require(deck, modulus, filling_kind());
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
