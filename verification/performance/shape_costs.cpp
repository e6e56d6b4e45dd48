// SPDX-License-Identifier: BSD-3-Clause
#include "shape_costs.hpp"

#include "base/region.hpp"
#include "shape/visit_kernels.hpp"
#include "step_cost.hpp"
#include "support/scenes.hpp"

#include <cstdio>
#include <cstring>

namespace barreno {
namespace {

/// Copper that flows everywhere, 2 particles per cell and direction.
Scene copper_block(Mode mode) {
  const bool space = mode == Mode::three_dimensional;
  Scene scene = testing::box_scene(
      mode,
      1e-3,
      {0.0, -0.004, space ? -0.004 : 0.0},
      {0.068, 0.132, space ? 0.036 : 0.0},
      testing::copper()
  );
  const Vector upper = space ? Vector{0.032, 0.032, 0.032} : Vector{0.064, 0.128, 0.0};
  testing::add_box(scene, "block", {0.0, 0.0, 0.0}, upper, 2);
  scene.bodies[0].velocity = {60.0, 60.0, space ? 60.0 : 0.0};
  scene.bodies[0].velocity_wave_number = {49.0, 25.0, 0.0};
  return scene;
}

double phase_nanoseconds(const char* label, double particle_steps) {
  for (const PhaseTime& phase : phase_times())
    if (std::strcmp(phase.label, label) == 0) return phase.seconds / particle_steps * 1e9;
  return 0.0;
}

void print_row(const char* mode, const Scene& scene, int steps, double particles) {
  const Cost cost = time_steps(scene, steps);
  std::printf(
      "  %-14s %-20s %6.0f ns %6.0f %6.0f %6.0f bytes\n",
      mode,
      scene.step.shape.c_str(),
      cost.best,
      phase_nanoseconds("project_particles", 5.0 * steps * particles),
      phase_nanoseconds("interpolate_motion", 5.0 * steps * particles),
      cost.bytes
  );
}

}  // namespace

void print_cost_of_shapes(int steps) {
  std::printf(
      "Shape functions, Johnson-Cook: ns per particle-step (fastest of five), of it project and "
      "interpolate, bytes per particle\n"
  );
  const auto print = [steps](const char* name, Mode mode, double particles) {
    Scene scene = copper_block(mode);
    for_each_shape([&](auto shape) {
      scene.step.shape = decltype(shape)::word;
      print_row(name, scene, steps, particles);
    });
  };
  print("axisymmetric", Mode::axisymmetric, 32768.0);
  print("plane strain", Mode::plane_strain, 32768.0);
  print("3D", Mode::three_dimensional, 262144.0);
}

}  // namespace barreno
