// SPDX-License-Identifier: BSD-3-Clause
#include "check/awake_parts.hpp"

#include "jet/path.hpp"
#include "scene/build_scene.hpp"
#include "scene/dormant.hpp"
#include "scene/geometry.hpp"
#include "scene/porous.hpp"
#include "scene/tile_levels.hpp"
#include "state/bodies/body_particles.hpp"

#include <algorithm>
#include <barreno/models.hpp>
#include <cmath>
#include <variant>

namespace barreno {
namespace {

/// What wakes tiles is far smaller than a wave, and grids spread it ahead of waves as by diffusion:
/// after the time t it is spread * sqrt(c h t) away, c the speed of waves and h the cell size.
/// Found with cells of 1, 2 and 5 mm in perforation_quick.xml and perforation_plane_gimp.xml, at 2
/// to 40 us, to about a tenth.
constexpr double spread = 15.0;

bool starts_at_rest(const BodySpec& body) {
  const auto nothing = [](const Vector& v) { return v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0; };
  return nothing(body.velocity) && nothing(body.velocity_wave_number) && body.spin == 0.0 &&
         body.radial_velocity == 0.0 && !body.motion.prescribed;
}

/// Speed of waves in a body as it starts.
double wave_speed(const Scene& scene, const BodySpec& body) {
  const MaterialSpec& material = scene.materials[static_cast<std::size_t>(body.material)];
  const double modulus = std::visit(
      [&](const auto& model) {
        const auto start = initial_state_of(model, body);
        return model.longitudinal_modulus(start.stress, start.history, start.volume_ratio);
      },
      material.material().model
  );
  return std::sqrt(modulus / material.density());
}

/// So large that the bodies have few particles.
GridSpec coarse_grid(const Scene& scene) {
  constexpr double enough = 1e4;
  GridSpec grid = uniform_grid(scene.grid, 0);
  const double finer = std::max(1.0, particle_estimate(scene) / enough);
  grid.cell_size *= std::ceil(std::pow(finer, 1.0 / dimensions(grid.mode)));
  return grid;
}

/// When the front that wakes tiles arrives at a place of a body; 0: all are awake from the start.
class Arrival {
public:
  Arrival(const Scene& scene, const BodySpec& body, double dt) {
    if (!foresees_dormancy(scene)) return;
    const JetPath path = jet_path(scene);
    const JetSlug& first = scene.jet.slugs.front();
    const double way = path.depth(path.face) - path.depth(scene.jet.launch_position);
    impact_ = first.time + way / first.velocity;
    face_ = path.face;
    front_ = wave_speed(scene, body);
    // From small cells where the jet is to large ones: with the mean of both, particle-steps of
    // refined perforations are within a sixth of those of the runs.
    const double h = std::sqrt(smallest_cell(scene.grid) * scene.grid.cell_size);
    diffusivity_ = spread * spread * front_ * h;
    // Where any motion wakes a tile, the grid carries it by a cell in a step.
    if (rest_motion(scene) == 0.0) front_ = std::max(front_, scene.grid.cell_size / dt);
  }

  double at(const Vector& x) const {
    if (front_ == 0.0) return 0.0;
    const double way = length_of({x[0], x[1] - face_, x[2]});
    return impact_ + std::min(way / front_, way * way / diffusivity_);
  }

private:
  double impact_ = 0.0, face_ = 0.0, front_ = 0.0, diffusivity_ = 0.0;
};

}  // namespace

void for_each_awake_part(
    const Scene& scene,
    const BodySpec& body,
    double dt,
    const std::function<void(const AwakePart&)>& visit
) {
  const Arrival arrival(scene, body, dt);
  const GridSpec grid = coarse_grid(scene);
  const int axes = dimensions(grid.mode);
  for_each_body_particle(grid, body, 0, [&](const NewParticle& p) {
    const int level = level_at(scene.grid, p.x);
    const double awake = std::clamp(1.0 - arrival.at(p.x) / scene.end_time, 0.0, 1.0);
    visit({p.x, level, std::pow(2.0, axes * level), awake});
  });
}

bool foresees_dormancy(const Scene& scene) {
  return scene.jet.present && !scene.jet.slugs.empty() && scene.step.skip_dormant &&
         std::all_of(scene.bodies.begin(), scene.bodies.end(), starts_at_rest) &&
         why_all_awake(scene).empty() && jet_path(scene).has_target;
}

}  // namespace barreno
