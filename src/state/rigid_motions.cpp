// SPDX-License-Identifier: BSD-3-Clause
#include "state/rigid_motions.hpp"

namespace barreno {

RigidMotions make_rigid_motions(const std::vector<BodySpec>& bodies, const VelocityFields& fields) {
  RigidMotions motions;
  std::vector<Table> factors;
  for (int b = 0; b < static_cast<int>(bodies.size()); ++b)
    for (int f = 0; f < fields.count; ++f) {
      if (fields.rigid_body[static_cast<std::size_t>(f)] != b) continue;
      const MotionSpec& motion = bodies[static_cast<std::size_t>(b)].motion;
      for (std::size_t d = 0; d < 3; ++d) motions.velocity[motions.count][d] = motion.velocity[d];
      factors.push_back(motion.factor);
      motions.of_field[f] = motions.count;
      motions.field[motions.count++] = f;
    }
  motions.factors = make_time_tables(factors);
  return motions;
}

}  // namespace barreno
