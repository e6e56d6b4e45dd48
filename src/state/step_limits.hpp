// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <limits>
#include <string>
#include <vector>

namespace barreno {

/// What can set the length of a step beside the particles of a material.
enum class OtherLimit { tiles_at_rest, cavity, growth, largest, output, strain };
constexpr int other_limits = 6;

/// What set the length of the steps so far; the same on every rank. A row for each material, in the
/// order of Scene::materials, then one for each of OtherLimit.
struct StepLimits {
  std::vector<double> time;      ///< spent in steps that it set [time]
  std::vector<double> steps;     ///< their number
  std::vector<double> shortest;  ///< of them, of its parts with Subcycles [time]
};

StepLimits make_step_limits(const Scene& scene);

/// Of the rows: names of materials, "growth limit" and so on.
std::vector<std::string> step_limit_names(const Scene& scene);

/// Row of a limit that is no material.
int row_of(OtherLimit limit, int materials);

/// Enters a step.  @param row  of what set it  @param part  its length, of its parts [time]
void count_step(int row, double time, double part, StepLimits& limits);

/// All of them in one list, as checkpoints have them, and back.
std::vector<double> values_of(const StepLimits& limits);
StepLimits step_limits_of(const std::vector<double>& values);

}  // namespace barreno
