// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/reproducible_sum.hpp"
#include "scene/velocity_fields.hpp"

#include <array>

namespace barreno {

/// Impulse by component, the same in every order of its parts.
using WholeImpulse = std::array<ReproducibleSum, 3>;
/// By rigid body, in the order of State::reactions.
using RigidImpulses = std::array<WholeImpulse, max_velocity_fields>;

/// What the other bodies have given to a rigid body since t = 0, on this rank's nodes.
struct Reaction {
  int body = 0;          ///< index into Scene::bodies
  int field = 0;         ///< its velocity field
  WholeImpulse impulse;  ///< [momentum]
};

}  // namespace barreno
