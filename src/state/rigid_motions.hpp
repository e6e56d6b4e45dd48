// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/time_tables.hpp"
#include "scene/velocity_fields.hpp"

#include <vector>

namespace barreno {

/// Motions of the rigid bodies of a scene as kernels read them, in the order of State::reactions.
struct RigidMotions {
  int count = 0;
  int field[max_velocity_fields] = {};                                   ///< velocity field of each
  int of_field[max_velocity_fields] = {-1, -1, -1, -1, -1, -1, -1, -1};  ///< by field; -1: none
  double velocity[max_velocity_fields][3] = {};  ///< times the factor of its table [length/time]
  TimeTables factors;

  /// Velocity of a body over the step from `time` on: that of its middle [length/time].
  KOKKOS_INLINE_FUNCTION void over_step(int body, double time, double dt, double (&v)[3]) const {
    const double factor = factors(body, time + 0.5 * dt);
    for (int d = 0; d < 3; ++d) v[d] = velocity[body][d] * factor;
  }
};

RigidMotions make_rigid_motions(const std::vector<BodySpec>& bodies, const VelocityFields& fields);

}  // namespace barreno
