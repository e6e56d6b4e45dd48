// SPDX-License-Identifier: BSD-3-Clause
// Cost of a step, phase by phase, beside the memory bandwidth of the same process.
#include "base/region.hpp"
#include "metal_points.hpp"
#include "rock_points.hpp"
#include "shape_costs.hpp"
#include "step_cost.hpp"
#include "support/scenes.hpp"
#include "triad.hpp"

#include <Tpetra_Core.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>

namespace barreno {
namespace {

/// An axisymmetric copper cylinder that flows everywhere: a converging velocity field in all of it.
/// @param empty  how much longer than usual the sides of the domain are
/// @param part   how long the sides of cylinder and domain are, in parts of the usual
Scene copper_cylinder(double empty, double part = 1.0) {
  Scene scene = testing::box_scene(
      Mode::axisymmetric,
      1e-3,
      {0.0, -0.004, 0.0},
      {0.128 * part * empty + 0.004, 0.256 * part * empty + 0.004, 0.0},
      testing::copper()
  );
  testing::add_box(scene, "cylinder", {0.0, 0.0, 0.0}, {0.128 * part, 0.256 * part, 0.0}, 2);
  scene.bodies[0].velocity = {60.0, 60.0, 0.0};
  scene.bodies[0].velocity_wave_number = {49.0, 25.0, 0.0};
  return scene;
}

/// An elastic block that shakes in three dimensions, compressed and sheared everywhere.
Scene elastic_block() {
  Scene scene = testing::box_scene(
      Mode::three_dimensional,
      1e-3,
      {-0.004, -0.004, -0.004},
      {0.028, 0.036, 0.028},
      testing::elastic(70e9, 0.3, 2700.0)
  );
  testing::add_box(scene, "block", {0.0, 0.0, 0.0}, {0.024, 0.032, 0.024}, 2);
  scene.bodies[0].velocity = {20.0, 30.0, 25.0};
  scene.bodies[0].velocity_wave_number = {150.0, 200.0, 170.0};
  return scene;
}

void print_phases(double particle_steps) {
  for (const PhaseTime& phase : phase_times())
    std::printf("  %-28s %8.1f ns\n", phase.label, phase.seconds / particle_steps * 1e9);
}

void print_costs(int steps) {
  const double triad = measure_triad();
  std::printf("triad %.1f GB/s\n", triad * 1e-9);
  print_cost_of_rock();
  print_cost_of_metal();
  const Scene scene = copper_cylinder(1.0);
  const Cost cost = time_steps(scene, steps);
  std::printf(
      "axisymmetric GIMP, Johnson-Cook: %.0f ns per particle-step, %.0f bytes per particle\n",
      cost.nanoseconds,
      cost.bytes
  );
  print_phases(131072.0 * 5.0 * steps);
  const Cost wide = time_steps(copper_cylinder(3.2), steps);
  std::printf(
      "the same in a ten times larger domain: %.0f ns (%+.1f %%)\n",
      wide.nanoseconds,
      100.0 * (wide.nanoseconds / cost.nanoseconds - 1.0)
  );
  // A quarter of the sides: the last cache holds all of its particles and nodes.
  constexpr double part = 0.25;
  const Cost small = time_steps(copper_cylinder(1.0, part), steps);
  std::printf(
      "the same with %.0f particles: %.0f ns (%+.1f %%)\n",
      131072.0 * part * part,
      small.nanoseconds,
      100.0 * (small.nanoseconds / cost.nanoseconds - 1.0)
  );
  const Cost space = time_steps(elastic_block(), steps);
  std::printf(
      "3D GIMP, elastic: %.0f ns per particle-step (at 12 GB/s: %.0f), %.0f bytes per particle\n",
      space.nanoseconds,
      space.nanoseconds * triad / 12e9,
      space.bytes
  );
  print_phases(147456.0 * 5.0 * steps);
  print_cost_of_shapes(steps, triad);
}

}  // namespace
}  // namespace barreno

int main(int argc, char** argv) {
  const Tpetra::ScopeGuard guard(&argc, &argv);
  try {
    barreno::print_costs(argc > 1 ? std::atoi(argv[1]) : 20);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 4;
  }
}
