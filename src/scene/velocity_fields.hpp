// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <vector>

namespace barreno {

/// What two velocity fields do to each other where both have mass, a < b.
struct FieldPair {
  int a = 0, b = 1;
  ContactKind kind = ContactKind::bonded;
  double friction = 0.0;
};

/// Materials that have their nodal velocities in common. Without contact and rigid bodies all share
/// field 0.
///
/// Materials share a field if there is no contact between them and both have the same contacts with
/// every other material; so what two fields do to each other is one thing. A rigid body has a field
/// of its own.
struct VelocityFields {
  int count = 1;
  std::vector<int> of_material;  ///< by material
  std::vector<int> rigid_body;   ///< by field: index into Scene::bodies, or -1
  std::vector<FieldPair> pairs;  ///< all but two rigid ones
};

/// Whether some of them meet at surfaces: pairs that are not bonded.
bool has_surfaces(const VelocityFields& fields);

/// Bits of both fields of a pair.
inline unsigned bits_of(const FieldPair& pair) {
  return 1U << static_cast<unsigned>(pair.a) | 1U << static_cast<unsigned>(pair.b);
}

/// Fields of one scene at most.
inline constexpr int max_velocity_fields = 8;

VelocityFields velocity_fields(const Scene& scene);

/// The rigid body that is made of a material, or -1.
int rigid_body_of(const Scene& scene, int material);

}  // namespace barreno
