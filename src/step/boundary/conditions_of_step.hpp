// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// The scene's conditions in the step from a clock on.
NodeConditions conditions_of_step(const NodeConditions& of_scene, const Clock& clock);

/// The same nodes and components, set to zero: what a correction of velocities must keep.
NodeConditions homogeneous(const NodeConditions& conditions);

}  // namespace barreno
