// SPDX-License-Identifier: BSD-3-Clause
#include "state/step_limits.hpp"

#include <algorithm>
#include <cassert>

namespace barreno {

StepLimits make_step_limits(const Scene& scene) {
  const std::vector<double> none(scene.materials.size() + other_limits, 0.0);
  return {none, none, none};
}

std::vector<std::string> step_limit_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const MaterialSpec& material : scene.materials) names.push_back(material.name());
  for (const char* other :
       {"tiles at rest",
        "fluid in a cavity",
        "growth limit",
        "largest step",
        "next output",
        "largest strain"})
    names.emplace_back(other);
  return names;
}

int row_of(OtherLimit limit, int materials) {
  return materials + static_cast<int>(limit);
}

void count_step(int row, double time, double part, StepLimits& limits) {
  const auto r = static_cast<std::size_t>(row);
  limits.shortest[r] = limits.steps[r] > 0.0 ? std::min(limits.shortest[r], part) : part;
  limits.time[r] += time;
  limits.steps[r] += 1.0;
}

std::vector<double> values_of(const StepLimits& limits) {
  std::vector<double> values = limits.time;
  values.insert(values.end(), limits.steps.begin(), limits.steps.end());
  values.insert(values.end(), limits.shortest.begin(), limits.shortest.end());
  return values;
}

StepLimits step_limits_of(const std::vector<double>& values) {
  assert(values.size() % 3 == 0);
  const auto rows = static_cast<std::ptrdiff_t>(values.size() / 3);
  const auto begin = values.begin();
  return {
      {begin, begin + rows}, {begin + rows, begin + 2 * rows}, {begin + 2 * rows, values.end()}};
}

}  // namespace barreno
