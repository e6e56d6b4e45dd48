// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace barreno::testing {

/// One way to take a step: transfer, order and shape function.
struct StepCase {
  std::string name;
  StepSpec step;
};

/// Every transfer: FLIP, its blend with PIC, PIC, XPIC(2), XPIC(3), APIC.
std::vector<StepCase> all_transfers();

/// Every transfer in every order of the step, for one shape function.
std::vector<StepCase> all_steps(const std::string& shape);

/// Every second of them, so that every transfer and every order is among them; which ones is told
/// by whether `turn` is even. BARRENO_EVERY_STEP in the environment: all of them.
std::vector<StepCase> steps_in_turn(const std::string& shape, int turn);

/// The words of all shape functions.
std::vector<std::string> all_shapes();

}  // namespace barreno::testing
