// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace barreno::testing {

/// The ranks of this program give the same bits as one alone, whose run the root repeats.
///
/// @param run      advances a state of the scene
/// @param numbers  what is compared of a state; all of its ranks call it
inline void expect_same_alone(
    const Scene& scene,
    const std::function<void(State&)>& run,
    const std::function<std::vector<std::vector<double>>(const State&)>& numbers = all_rows
) {
  State together = start(scene);
  run(together);
  const auto expected = numbers(together);
  on_root([&] {
    State alone = start_alone(scene);
    run(alone);
    EXPECT_EQ(numbers(alone), expected);
  });
}

}  // namespace barreno::testing
