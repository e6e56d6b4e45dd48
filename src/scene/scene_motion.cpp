// SPDX-License-Identifier: BSD-3-Clause
#include "scene/load_tables.hpp"
#include "scene/scene_parts.hpp"
#include "scene/velocity_fields.hpp"

namespace barreno {
MotionSpec read_motion(const Deck& deck, const std::string& path, Mode mode) {
  MotionSpec motion;
  if (!deck.has(path + "/Motion")) {
    for (const char* name : {"/Motion Times", "/Motion Factors"})
      if (deck.has(path + name))
        deck.refuse_value(path + name, "has no meaning without Motion; add it or remove this");
    return motion;
  }
  for (const char* name : {"/Velocity", "/Velocity Wave Number", "/Radial Velocity", "/Spin"})
    if (deck.has(path + name))
      deck.refuse_value(
          path + name, "has no meaning beside Motion (the body moves as that says); remove one"
      );
  motion.prescribed = true;
  motion.velocity = vector_at(deck, path + "/Motion", mode);
  if (mode == Mode::axisymmetric && motion.velocity[0] != 0.0)
    deck.refuse_value(
        path + "/Motion", "has a radial component (a ring would have to stretch); make it zero"
    );
  motion.factor = read_factors(deck, path, "Motion ");
  return motion;
}

void check_rigid_bodies(const Deck& deck, const Scene& scene) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const BodySpec& body = scene.bodies[b];
    if (!body.motion.prescribed) continue;
    const std::string path = "Bodies/" + body.name;
    for (std::size_t k = 0; k < scene.bodies.size(); ++k)
      if (k != b && scene.bodies[k].material == body.material)
        deck.refuse_value(
            path + "/Material",
            "is also that of Bodies/" + scene.bodies[k].name +
                " (a body with Motion needs one of its own); give it another list in Materials, of "
                "the same Card"
        );
    if (scene.jet.present && scene.jet.material == body.material)
      deck.refuse_value(
          path + "/Material",
          "is also that of the Jet (a body with Motion needs one of its own); give it another list "
          "in Materials, of the same Card"
      );
    for (const PressureLoadSpec& load : scene.loads)
      if (load.body == static_cast<int>(b))
        deck.refuse(
            path + "/Motion",
            "belongs to a body that '" + load.name +
                "' presses (a rigid body does not feel it); remove one of the two"
        );
  }
}

}  // namespace barreno
