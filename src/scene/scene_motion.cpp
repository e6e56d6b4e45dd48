// SPDX-License-Identifier: BSD-3-Clause
#include "deck/section_table.hpp"
#include "scene/load_tables.hpp"
#include "scene/scene_parts.hpp"
#include "scene/velocity_fields.hpp"

namespace barreno {

MotionSpec read_motion(const Deck& deck, const std::string& body, Mode mode) {
  const std::string path = list_of<BodySpec>(body), entry = path_of(&MotionSpec::velocity, body);
  auto motion = read_list<MotionSpec>(deck, path);
  const std::string of = name_of(&MotionSpec::velocity) + " ";
  if (!deck.has(entry)) {
    for (const char* name : {times_word, factors_word}) {
      const std::string without = input::join(path, of + name);
      if (deck.has(without))
        deck.refuse_value(without, "has no meaning without Motion; add Motion or remove this");
    }
    return motion;
  }
  for (const std::string& other :
       {path_of(&BodySpec::velocity, body),
        path_of(&BodySpec::velocity_wave_number, body),
        path_of(&BodySpec::radial_velocity, body),
        path_of(&BodySpec::spin, body)})
    if (deck.has(other))
      deck.refuse_value(
          other, "cannot be combined with Motion (which prescribes how the body moves); remove one"
      );
  motion.prescribed = true;
  if (mode == Mode::axisymmetric && motion.velocity[0] != 0.0)
    deck.refuse_value(entry, "has a radial component (a ring would have to stretch); make it zero");
  motion.factor = read_factors(deck, path, of);
  return motion;
}

void check_rigid_bodies(const Deck& deck, const Scene& scene) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const BodySpec& body = scene.bodies[b];
    if (!body.motion.prescribed) continue;
    const std::string material = path_of(&BodySpec::material, body.name);
    for (std::size_t k = 0; k < scene.bodies.size(); ++k)
      if (k != b && scene.bodies[k].material == body.material)
        deck.refuse_value(
            material,
            "is also the material of " + list_of<BodySpec>(scene.bodies[k].name) +
                " (a body with Motion needs its own); add another list in Materials, with the same "
                "Card, and use that"
        );
    if (scene.jet.present && scene.jet.material == body.material)
      deck.refuse_value(
          material,
          "is also the material of the Jet (a body with Motion needs its own); add another list in "
          "Materials, with the same Card, and use that"
      );
    for (const PressureLoadSpec& load : scene.loads)
      if (load.body == static_cast<int>(b))
        deck.refuse(
            path_of(&MotionSpec::velocity, body.name),
            "belongs to a body that '" + load.name +
                "' acts on (a load has no effect on a rigid body); remove one of the two"
        );
  }
}

}  // namespace barreno
