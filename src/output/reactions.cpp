// SPDX-License-Identifier: BSD-3-Clause
#include "output/reactions.hpp"

#include "base/gather.hpp"
#include "files/text_file.hpp"

namespace barreno {
namespace {

/// Axes along which a rigid body can have a resultant, as [first, end).
struct Axes {
  int first, end;
};
Axes axes_of(Mode mode) {
  return {mode == Mode::axisymmetric ? 1 : 0, dimensions(mode)};
}

}  // namespace

std::vector<double> reaction_impulses(const State& state) {
  const Axes axes = axes_of(state.grid.mode);
  std::vector<ReproducibleSum> sums;
  for (const Reaction& reaction : state.reactions)
    for (int d = axes.first; d < axes.end; ++d)
      sums.push_back(reaction.impulse[static_cast<std::size_t>(d)]);
  if (sums.empty()) return {};
  sum_over_ranks(*state.grid.comm, sums);
  std::vector<double> impulses;
  impulses.reserve(sums.size());
  for (const ReproducibleSum& sum : sums) impulses.push_back(sum.value());
  return impulses;
}

std::vector<std::string> reaction_columns(const Scene& scene) {
  std::vector<std::string> columns;
  const Axes axes = axes_of(scene.grid.mode);
  for (const BodySpec& body : scene.bodies) {
    if (!body.motion.prescribed) continue;
    for (int d = axes.first; d < axes.end; ++d)
      for (const char* what : {"_force_", "_impulse_"})
        columns.push_back(column_name(body.name) + what + "xyz"[d]);
  }
  return columns;
}

std::vector<double> reaction_values(
    const std::vector<double>& impulses, const std::vector<double>& before, double elapsed
) {
  std::vector<double> values;
  for (std::size_t i = 0; i < impulses.size(); ++i) {
    values.push_back(elapsed > 0.0 ? (impulses[i] - before[i]) / elapsed : 0.0);
    values.push_back(impulses[i]);
  }
  return values;
}

}  // namespace barreno
