// SPDX-License-Identifier: BSD-3-Clause
#include "state/tally_scales.hpp"

#include "base/numbers.hpp"
#include "state/build_state.hpp"

#include <algorithm>
#include <barreno/history_values.hpp>
#include <barreno/models.hpp>
#include <cmath>
#include <type_traits>
#include <variant>

namespace barreno {
namespace {

double modulus_at_rest(const Scene& scene, int material) {
  const StartPoint at_rest =
      start_point(scene.materials[static_cast<std::size_t>(material)], nullptr);
  return std::visit(
      [&](const auto& model) {
        auto history = model.initial_history();
        std::copy(
            at_rest.history.begin(),
            at_rest.history.end(),
            history_values<std::decay_t<decltype(model)>>(history)
        );
        return model.longitudinal_modulus(at_rest.stress, history, at_rest.volume_ratio);
      },
      scene.materials[static_cast<std::size_t>(material)].material().model
  );
}

double largest_cell(const GridSpec& grid) {
  double volume = std::pow(grid.cell_size, dimensions(grid.mode));
  if (grid.mode == Mode::axisymmetric) volume *= two_pi * grid.upper[0];
  return volume;
}

}  // namespace

TallyScales tally_scales(const Scene& scene, int material) {
  const double density = scene.materials[static_cast<std::size_t>(material)].density();
  const double volume = largest_cell(scene.grid), modulus = modulus_at_rest(scene, material);
  return {
      SplitScales(density * volume),
      SplitScales(std::sqrt(density * modulus) * volume),
      SplitScales(modulus * volume)};
}

}  // namespace barreno
