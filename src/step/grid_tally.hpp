// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/reproducible_sum.hpp"

namespace barreno {

/// Kinetic energy and momentum on the grid over one step, this rank's nodes, each counted once.
struct GridTally {
  ReproducibleSum kinetic_before;  ///< after conditions were put on v^n
  ReproducibleSum kinetic_after;
  ReproducibleSum force_work;         ///< sum f . v_mean dt, all nodes
  ReproducibleSum condition_work;     ///< of the conditions on the material
  ReproducibleSum condition_impulse;  ///< axial, of the conditions on the material
  ReproducibleSum filter_impulse;     ///< axial, what the conditions changed in v^n
  ReproducibleSum
      taken_impulse;       ///< what of it reaches particles: by PIC only, the grid's share of it
  ReproducibleSum damped;  ///< work done against the damping, part of force_work
  ReproducibleSum damping_impulse;  ///< axial, of the damping
  ReproducibleSum
      absorbed;  ///< work of the impedances on the change of velocity, part of force_work
  ReproducibleSum absorbed_impulse;  ///< axial, of the same
  ReproducibleSum contact_work;      ///< impulses of contact times mean velocity
  ReproducibleSum tangential_work;   ///< the same of their parts along surfaces
};

}  // namespace barreno
