// SPDX-License-Identifier: BSD-3-Clause
#include "scene/scene_parts.hpp"
#include "scene/velocity_fields.hpp"

#include <algorithm>

namespace barreno {
namespace {

ContactKind contact_kind(const std::string& word) {
  if (word == "stick") return ContactKind::stick;
  return word == "friction" ? ContactKind::friction : ContactKind::frictionless;
}

std::array<int, 2> pair_at(const Deck& deck, const std::string& path) {
  const std::array<int, 2> pair{
      material_at(deck, path + "/Material"), material_at(deck, path + "/Other Material")};
  if (pair[0] == pair[1])
    deck.refuse_value(
        path + "/Other Material",
        "is the first material too (contact is between materials, not between bodies); give the "
        "second body a list of its own in Materials, of the same Card, and name that"
    );
  return pair;
}

double friction_at(const Deck& deck, const std::string& path, ContactKind kind) {
  const bool given = deck.has(path);
  if (given && kind != ContactKind::friction)
    deck.refuse_value(path, "has no meaning for this Kind; remove it or write friction");
  if (!given && kind == ContactKind::friction)
    deck.refuse(path, "is missing (Kind friction needs it); add it");
  return given ? deck.number(path) : 0.0;
}

void check_new_pair(
    const Deck& deck, const Scene& scene, const ContactSpec& contact, const std::string& path
) {
  for (const ContactSpec& other : scene.contacts)
    if (std::is_permutation(
            contact.materials.begin(), contact.materials.end(), other.materials.begin()
        ))
      deck.refuse_value(
          path, "has a contact with the first already, '" + other.name + "'; remove one of the two"
      );
  if (rigid_body_of(scene, contact.materials[0]) >= 0 &&
      rigid_body_of(scene, contact.materials[1]) >= 0)
    deck.refuse_value(
        path,
        "is of a body with Motion, and so is the first material (neither can give way to the "
        "other); "
        "remove the entry"
    );
}

}  // namespace

void add_contacts(const Deck& deck, Scene& scene) {
  for (const std::string& name : deck.lists("Contact")) {
    const std::string path = "Contact/" + name;
    ContactSpec contact;
    contact.name = name;
    contact.materials = pair_at(deck, path);
    contact.kind = contact_kind(deck.word(path + "/Kind"));
    contact.friction = friction_at(deck, path + "/Friction Coefficient", contact.kind);
    check_new_pair(deck, scene, contact, path + "/Other Material");
    scene.contacts.push_back(contact);
  }
  const int fields = velocity_fields(scene).count;
  if (fields > most_velocity_fields)
    deck.refuse(
        "Contact",
        "needs " + std::to_string(fields) + " velocity fields (there can be " +
            std::to_string(most_velocity_fields) +
            "; each rigid body and each group of materials with equal contacts has one); use fewer "
            "materials"
    );
}

}  // namespace barreno
