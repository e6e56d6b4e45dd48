// SPDX-License-Identifier: BSD-3-Clause
// Nothing in the step asks for memory after the first steps, whatever the scene asks for. What
// asks: a tile that wakes, a particle that is lost or goes to another rank, a new slug.
#include "shape/visit_kernels.hpp"
#include "support/count_allocations.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace barreno {
namespace {

using testing::add_box;
using testing::add_symmetry;
using testing::advance_to;
using testing::all_modes;
using testing::box_scene;
using testing::start_alone;

/// Long enough for the rows to be put in order once.
constexpr long first_steps = 60;
constexpr long counted_steps = 60;

/// Requests for memory of the steps after the first ones. BARRENO_ABORT_ON_ALLOCATION in the
/// environment ends the program in the first of them.
long later_allocations(const Scene& scene) {
  State rehearsal = start_alone(scene);  // a kernel's name is made at its first launch
  advance_to(scene, 1.0, rehearsal, first_steps + counted_steps);
  State state = start_alone(scene);
  const auto tiles = [&] { return state.grid.active; };
  advance_to(scene, 1.0, state, first_steps);
  const int before = tiles();
  const long start = testing::allocations();
  testing::abort_on_allocation(std::getenv("BARRENO_ABORT_ON_ALLOCATION") != nullptr);
  advance_to(scene, 1.0, state, counted_steps);
  testing::abort_on_allocation(false);
  const long count = testing::allocations() - start;
  EXPECT_EQ(tiles(), before) << "a tile woke: the scene is no test of steps without";
  EXPECT_EQ(state.clock.step, first_steps + counted_steps);
  return count;
}

/// A block that shakes and drifts through its cells, with a little of it in every tile around.
Scene shaking_block(Mode mode, const MaterialSpec& material) {
  constexpr double h = 1e-3;
  const double x = mode == Mode::axisymmetric ? 0.0 : 2.0 * h;
  Scene scene = box_scene(mode, h, {0.0, 0.0, 0.0}, {16.0 * h, 16.0 * h, 8.0 * h}, material);
  BodySpec& body = add_box(scene, "block", {x, 2.0 * h, 2.0 * h}, {13.0 * h, 13.0 * h, 6.0 * h}, 2);
  body.velocity = {mode == Mode::axisymmetric ? 0.0 : 20.0, 30.0, 10.0};
  if (mode == Mode::axisymmetric) add_symmetry(scene, Face::x_lower);
  return scene;
}

TEST(Allocations, AStepOfEveryShapeFunctionInEveryModeMakesNone) {
  for (const Mode mode : all_modes)
    for_each_shape([&](auto shape) {
      Scene scene = shaking_block(mode, testing::copper());
      scene.step.shape = decltype(shape)::word;
      EXPECT_EQ(later_allocations(scene), 0)
          << decltype(shape)::word << ", mode " << static_cast<int>(mode);
    });
}

TEST(Allocations, LoadsWallsAndBodyForcesMakeNone) {
  for (const Mode mode : all_modes) {
    Scene scene = shaking_block(mode, testing::elastic(70e9, 0.3, 2700.0));
    PressureLoadSpec load;
    load.name = "pressure";
    load.faces[static_cast<std::size_t>(Face::y_upper)] = true;
    load.pressure = {{0.0}, {1e7}};
    scene.loads.push_back(load);
    load.kind = LoadKind::non_reflecting;
    load.faces = {};
    load.faces[static_cast<std::size_t>(Face::x_upper)] = true;
    scene.loads.push_back(load);
    scene.body_force.kind = BodyForceKind::gravity;
    scene.body_force.acceleration = {0.0, -9.81, 0.0};
    add_symmetry(scene, Face::y_lower);
    EXPECT_EQ(later_allocations(scene), 0) << "mode " << static_cast<int>(mode);
  }
}

TEST(Allocations, TransfersAndOrdersMakeNone) {
  for (const Mode mode : all_modes)
    for (const Transfer transfer : {Transfer::flip, Transfer::xpic, Transfer::apic})
      for (const Order order :
           {Order::stress_last, Order::modified_stress_last, Order::stress_first}) {
        Scene scene = shaking_block(mode, testing::elastic(70e9, 0.3, 2700.0));
        scene.step.transfer = transfer;
        scene.step.order = order;
        EXPECT_EQ(later_allocations(scene), 0)
            << "mode " << static_cast<int>(mode) << ", transfer " << static_cast<int>(transfer)
            << ", order " << static_cast<int>(order);
      }
}

TEST(Allocations, APoreFluidMakesNone) {
  Scene scene = box_scene(
      Mode::axisymmetric,
      1e-3,
      {0.0, -0.008, 0.0},
      {0.016, 0.024, 0.0},
      testing::elastic(70e9, 0.3, 2700.0)
  );
  BodySpec body;
  body.name = "ball";
  body.shape = Ball{{0.0, 8e-3, 0.0}, 12e-3, 4e-3};
  body.particles_per_cell = 2;
  scene.bodies.push_back(body);
  PressureLoadSpec fluid;
  fluid.name = "fluid";
  fluid.kind = LoadKind::pore_fluid;
  fluid.surfaces = {true, false};
  fluid.pressure = {{0.0}, {1e6}};
  fluid.bulk_modulus = 2.2e9;
  scene.loads.push_back(fluid);
  add_symmetry(scene, Face::x_lower);
  EXPECT_EQ(later_allocations(scene), 0);
}

TEST(Allocations, ContactMakesNone) {
  for (const Mode mode : all_modes) {
    Scene scene = shaking_block(mode, testing::elastic(70e9, 0.3, 2700.0));
    scene.materials.push_back(scene.materials[0]);
    BodySpec other = scene.bodies[0];
    Box& low = std::get<Box>(scene.bodies[0].shape);
    Box high = low;
    low.upper[1] = high.lower[1] = 7.5e-3;
    other.shape = high;
    other.name = "other";
    other.material = 1;
    other.velocity[1] = -30.0;
    scene.bodies.push_back(other);
    scene.contacts.push_back({"faces", {0, 1}, ContactKind::friction, 0.3});
    EXPECT_EQ(later_allocations(scene), 0) << "mode " << static_cast<int>(mode);
  }
}

TEST(Allocations, ARigidBodyMakesNone) {
  for (const Mode mode : all_modes) {
    Scene scene = shaking_block(mode, testing::elastic(70e9, 0.3, 2700.0));
    scene.materials.push_back(scene.materials[0]);
    BodySpec punch = scene.bodies[0];
    Box& block = std::get<Box>(scene.bodies[0].shape);
    Box& face = std::get<Box>(punch.shape);
    block.upper[1] = face.lower[1] = 7.5e-3;
    punch.name = "punch";
    punch.material = 1;
    punch.velocity = {};
    punch.motion.prescribed = true;
    punch.motion.velocity = {0.0, -1.0, 0.0};
    scene.bodies.push_back(punch);
    scene.contacts.push_back({"face", {0, 1}, ContactKind::friction, 0.3});
    EXPECT_EQ(later_allocations(scene), 0) << "mode " << static_cast<int>(mode);
  }
}

}  // namespace
}  // namespace barreno
