// SPDX-License-Identifier: BSD-3-Clause
#include "state/isolated_courant.hpp"

#include "shape/visit_kernels.hpp"
#include "state/bodies/body_particles.hpp"

#include <algorithm>
#include <barreno/tangent.hpp>
#include <cmath>
#include <limits>
#include <variant>

namespace barreno {
namespace {

/// What is left for a particle that is compressed meanwhile, and for artificial viscosity.
constexpr double margin = 0.9;

/// lambda / M of a material at rest.
double lateral_share(const Material& material) {
  return std::visit(
      [](const auto& model) {
        const auto history = model.initial_history();
        const double axial = model.longitudinal_modulus({}, history, 1.0);
        const double shear = shear_modulus(model, Sym3{}, history);
        return axial > 0.0 ? std::clamp(1.0 - 2.0 * shear / axial, 0.0, 1.0) : 0.0;
      },
      material.model
  );
}

}  // namespace

double isolated_courant(const Scene& scene, int material) {
  return isolated_courant(scene, material, smallest_half_size(scene, material));
}

double isolated_courant(const Scene& scene, int material, double half_size) {
  const StepSpec& step = scene.step;
  if (!step.stable_alone || step.order != Order::stress_last || step.transfer == Transfer::apic)
    return std::numeric_limits<double>::infinity();
  const double bar = visit_shape(step.shape, [&](auto shape) {
    return decltype(shape)::isolated_courant(half_size);
  });
  const double strains = scene.grid.mode == Mode::plane_strain ? 2.0 : 3.0;
  const auto m = static_cast<std::size_t>(material);
  const double stiffer = 1.0 + (strains - 1.0) * lateral_share(scene.materials[m].material());
  return margin * bar / std::sqrt(stiffer);
}

}  // namespace barreno
