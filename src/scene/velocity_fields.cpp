// SPDX-License-Identifier: BSD-3-Clause
#include "scene/velocity_fields.hpp"

#include <algorithm>

namespace barreno {
namespace {

/// Contact between two materials; bonded if the scene asks for none.
FieldPair law_between(const Scene& scene, int m, int k) {
  for (const ContactSpec& contact : scene.contacts) {
    const auto& [first, second] = contact.materials;
    if ((first == m && second == k) || (first == k && second == m))
      return {0, 1, contact.kind, contact.friction};
  }
  return {};
}

bool same(const FieldPair& a, const FieldPair& b) {
  return a.kind == b.kind && a.friction == b.friction;
}

/// Neither can be told from the other by what third materials do to them.
bool may_share(const Scene& scene, int m, int k) {
  if (rigid_body_of(scene, m) >= 0 || rigid_body_of(scene, k) >= 0) return false;
  if (law_between(scene, m, k).kind != ContactKind::bonded) return false;
  for (int other = 0; other < static_cast<int>(scene.materials.size()); ++other)
    if (other != m && other != k &&
        !same(law_between(scene, m, other), law_between(scene, k, other)))
      return false;
  return true;
}

}  // namespace

int rigid_body_of(const Scene& scene, int material) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (scene.bodies[b].material == material && scene.bodies[b].motion.prescribed)
      return static_cast<int>(b);
  return -1;
}

bool has_surfaces(const VelocityFields& fields) {
  return std::any_of(fields.pairs.begin(), fields.pairs.end(), [](const FieldPair& pair) {
    return pair.kind != ContactKind::bonded;
  });
}

VelocityFields velocity_fields(const Scene& scene) {
  VelocityFields fields;
  std::vector<int> first;  // material of every field
  for (int m = 0; m < static_cast<int>(scene.materials.size()); ++m) {
    int field = 0;
    while (field < static_cast<int>(first.size()) &&
           !may_share(scene, m, first[static_cast<std::size_t>(field)]))
      ++field;
    if (field == static_cast<int>(first.size())) {
      first.push_back(m);
      fields.rigid_body.push_back(rigid_body_of(scene, m));
    }
    fields.of_material.push_back(field);
  }
  fields.count = static_cast<int>(first.size());
  for (int a = 0; a < fields.count; ++a)
    for (int b = a + 1; b < fields.count; ++b) {
      const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
      if (fields.rigid_body[i] >= 0 && fields.rigid_body[j] >= 0) continue;
      FieldPair pair = law_between(scene, first[i], first[j]);
      pair.a = a;
      pair.b = b;
      fields.pairs.push_back(pair);
    }
  return fields;
}

}  // namespace barreno
