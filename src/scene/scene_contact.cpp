// SPDX-License-Identifier: BSD-3-Clause
#include "deck/section_table.hpp"
#include "scene/scene_parts.hpp"
#include "scene/velocity_fields.hpp"

#include <algorithm>

namespace barreno {
namespace {

std::array<int, 2> pair_at(const Deck& deck, const std::string& path) {
  const std::string first = input::join(path, material_word);
  const std::string other = input::join(path, other_material_word);
  const std::array<int, 2> pair{material_at(deck, first), material_at(deck, other)};
  if (pair[0] == pair[1])
    deck.refuse_value(
        other,
        "is the first material too (contact is between materials, not between bodies); add another "
        "list in Materials with the same Card for the second body, and name it here"
    );
  return pair;
}

/// Of the kind friction alone.
void check_friction(const Deck& deck, const std::string& path, ContactKind kind) {
  const bool given = deck.has(path);
  if (given && kind != ContactKind::friction)
    deck.refuse_value(path, "has no meaning for this Kind; remove it or write friction");
  if (!given && kind == ContactKind::friction)
    deck.refuse(path, "is missing (Kind friction needs it); add it");
}

void check_new_pair(
    const Deck& deck, const Scene& scene, const ContactSpec& contact, const std::string& path
) {
  for (const ContactSpec& other : scene.contacts)
    if (std::is_permutation(
            contact.materials.begin(), contact.materials.end(), other.materials.begin()
        ))
      deck.refuse_value(
          path,
          "already has a contact with the first material, '" + other.name +
              "'; remove one of the two"
      );
  if (rigid_body_of(scene, contact.materials[0]) >= 0 &&
      rigid_body_of(scene, contact.materials[1]) >= 0)
    deck.refuse_value(
        path,
        "is of a body with Motion, and so is the first material (neither can give way to the "
        "other); remove the entry"
    );
}

}  // namespace

void add_contacts(const Deck& deck, Scene& scene) {
  const std::string& section = table_of<ContactSpec>().path;
  for (const std::string& name : deck.lists(section)) {
    const std::string path = list_of<ContactSpec>(name);
    auto contact = read_list<ContactSpec>(deck, path);
    contact.name = name;
    contact.materials = pair_at(deck, path);
    check_friction(deck, path_of(&ContactSpec::friction, name), contact.kind);
    check_new_pair(deck, scene, contact, input::join(path, other_material_word));
    scene.contacts.push_back(contact);
  }
  const int fields = velocity_fields(scene).count;
  if (fields > max_velocity_fields)
    deck.refuse(
        section,
        "needs " + std::to_string(fields) + " velocity fields (there can be " +
            std::to_string(max_velocity_fields) +
            "; each rigid body and each group of materials with equal contacts has one); use fewer "
            "materials"
    );
}

}  // namespace barreno
