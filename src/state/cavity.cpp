// SPDX-License-Identifier: BSD-3-Clause
#include "state/cavity.hpp"

#include "state/surface_share.hpp"

namespace barreno {

std::vector<Cavity> make_cavities(const Scene& scene) {
  std::vector<Cavity> cavities(scene.loads.size());
  for (std::size_t l = 0; l < scene.loads.size(); ++l) {
    const PressureLoadSpec& load = scene.loads[l];
    if (!traits_of(load.kind).fills_hollow) continue;
    const BodySpec& body = scene.bodies[static_cast<std::size_t>(load.body)];
    const Ball& ball = std::get<Ball>(body.shape);
    const double volume = cavity_volume(ball, scene.grid);
    cavities[l] = {
        volume,
        volume,
        ball.inner_radius,
        scene.materials[static_cast<std::size_t>(body.material)].density(),
        load.bulk_modulus,
        scene.grid.mode == Mode::plane_strain ? 2 : 3};
  }
  return cavities;
}

}  // namespace barreno
