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

/// What the machine can do, measured in this process.
struct Machine {
  double bytes_per_second, operations_per_second;
};

void print_row(
    const char* mode, const Scene& scene, int steps, double particles, const Machine& machine
) {
  const Cost cost = time_steps(scene, steps);
  const LeastWork& least = cost.least;
  const double limit = 1e9 * least.seconds(machine.bytes_per_second, machine.operations_per_second);
  std::printf(
      "| %s | %s | %.0f | %.1f | %.0f | %.0f | %.0f | %.2f | %.0f | %.0f | %.0f |\n",
      mode,
      scene.step.shape.c_str(),
      cost.best,
      least.nodes,
      least.bytes,
      least.operations,
      limit,
      limit / cost.best,
      phase_nanoseconds("project_particles", 5.0 * steps * particles),
      phase_nanoseconds("interpolate_motion", 5.0 * steps * particles),
      cost.bytes
  );
}

}  // namespace

void print_cost_of_shapes(int steps, double triad) {
  const Machine machine{triad, measure_arithmetic()};
  std::printf(
      "Shape functions, Johnson-Cook, %.1f GB/s, %.1f GFlop/s: per particle-step, the fastest of "
      "five\n| mode | shape function | ns | nodes | least bytes | least operations | limit ns | "
      "fraction | project ns | interpolate ns | memory bytes |\n|---|---|---|---|---|---|---|---|"
      "---|---|---|\n",
      triad * 1e-9,
      machine.operations_per_second * 1e-9
  );
  const auto print = [&](const char* name, Mode mode, double particles) {
    Scene scene = copper_block(mode);
    for_each_shape([&](auto shape) {
      scene.step.shape = decltype(shape)::word;
      print_row(name, scene, steps, particles, machine);
    });
  };
  print("axisymmetric", Mode::axisymmetric, 32768.0);
  print("plane strain", Mode::plane_strain, 32768.0);
  print("3D", Mode::three_dimensional, 262144.0);
}

}  // namespace barreno
