// SPDX-License-Identifier: BSD-3-Clause
// What sets the transfers apart: rotation, linear velocities, what they lose.
#include "shape/visit_kernels.hpp"
#include "state/shape_fields.hpp"
#include "step/transfer/node_moments.hpp"
#include "support/scenes.hpp"
#include "unit/step/transfer_cases.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

namespace barreno {
namespace {

using testing::add_box;
using testing::advance_to;
using testing::all_shapes;
using testing::all_steps;
using testing::all_transfers;
using testing::start_alone;
using testing::StepCase;

/// Angular momentum about the origin, what APIC remembers included.
double spin_of(const State& state) {
  double sum = 0.0;
  for (const Particles& particles : state.particles)
    for (int p = 0; p < particles.count; ++p) {
      double spin = particles.position(p, 0) * particles.velocity(p, 1) -
                    particles.position(p, 1) * particles.velocity(p, 0);
      if (particles.affine.components > 0) spin += particles.affine(p, 2) - particles.affine(p, 1);
      sum += particles.mass(p) * spin;
    }
  return sum;
}

TEST(TransferMotions, ApicKeepsAngularMomentumOfATurningBodyAndPicDoesNot) {
  for (const std::string& shape : all_shapes())
    for (const StepCase& one : all_steps(shape)) {
      SCOPED_TRACE(one.name);
      Scene scene = testing::box_scene(
          Mode::plane_strain,
          1.0,
          {-8.0, -8.0, 0.0},
          {8.0, 8.0, 0.0},
          testing::elastic(1e4, 0.3, 1.0)
      );
      scene.step = one.step;
      add_box(scene, "bar", {-2.3, -1.2, 0.0}, {2.3, 1.2, 0.0}, 2).spin = 4.0;
      State state = start_alone(scene);
      advance_to(scene, 1.0, state, 1);  // particles remember their first moments from here on
      const double before = spin_of(state);
      advance_to(scene, 1.0, state, 60);
      const double change = spin_of(state) / before - 1.0;
      if (one.step.transfer == Transfer::apic) {
        EXPECT_NEAR(change, 0.0, 1e-12);
      }
      if (one.name.rfind("PIC", 0) == 0) {
        EXPECT_LT(change, -0.05);
      }
    }
}

TEST(TransferMotions, ApicBeginsWithTheWholeSpin) {
  for (const std::string& shape : all_shapes()) {
    SCOPED_TRACE(shape);
    Scene scene = testing::box_scene(
        Mode::plane_strain, 1.0, {-8.0, -8.0, 0.0}, {8.0, 8.0, 0.0}, testing::elastic(1.0, 0.3, 1.0)
    );
    scene.step.shape = shape;
    scene.step.transfer = Transfer::apic;
    scene.step.pic_fraction = 1.0;
    scene.step.largest_step = 1e-14;
    add_box(scene, "bar", {-2.3, -1.2, 0.0}, {2.3, 1.2, 0.0}, 2).spin = 4.0;
    State state = start_alone(scene);
    advance_to(scene, 1.0, state, 1);
    const Particles& particles = state.particles[0];
    for (int p = 0; p < particles.count; ++p) {
      EXPECT_NEAR(particles.velocity(p, 0), -4.0 * particles.position(p, 1), 1e-10);
      EXPECT_NEAR(particles.velocity(p, 1), 4.0 * particles.position(p, 0), 1e-10);
    }
  }
}

/// Gives row p the velocity g x, and in APIC the first moments that belong to it.
template <class M, class S>
void set_linear(
    const PatchFrame<M::dimensions>& frame,
    const double (&g)[2][2],
    int tile,
    int p,
    const Particles& particles
) {
  const auto particle = frame.template geometry<S>(frame.first(tile), shape_fields(particles), p);
  const NodeMoments<2> moments(frame.patch, S::template support<M>(particle));
  const double square = 1.0 / (particle.per_cell * particle.per_cell);
  for (int i = 0; i < 2; ++i) {
    particles.velocity(p, i) =
        g[i][0] * particles.position(p, 0) + g[i][1] * particles.position(p, 1);
    if (particles.affine.components == 0) continue;
    for (int d = 0; d < 2; ++d)
      particles.affine(p, 2 * i + d) =
          square * (g[i][0] * moments.second[0][d] + g[i][1] * moments.second[1][d]);
  }
}

/// Largest change of a linear velocity field at particles near the middle of a body in one step
/// that hardly moves it; `scatter` takes the particles off their lattice.
double change_of_linear_field(const StepSpec& step, double scatter) {
  const double g[2][2] = {{0.3, -0.8}, {0.5, 0.2}};
  Scene scene = testing::box_scene(
      Mode::plane_strain,
      1.0,
      {-18.0, -18.0, 0.0},
      {18.0, 18.0, 0.0},
      testing::elastic(1.0, 0.3, 1.0)
  );
  scene.step = step;
  scene.step.largest_step = 1e-14;
  add_box(scene, "box", {-15.5, -15.5, 0.0}, {15.5, 15.5, 0.0}, 2);
  State state = start_alone(scene);
  Particles& particles = state.particles[0];
  for (int p = 0; p < particles.count; ++p)
    for (int d = 0; d < 2; ++d) particles.position(p, d) += scatter * std::sin(3.1 * p + 1.3 * d);
  advance_to(scene, 1.0, state, 1);  // places the particles
  visit_shape(step.shape, [&](auto shape) {
    const PatchFrame<2> frame(state.grid);
    for (int tile = 0; tile < state.grid.active; ++tile)
      for (int k = particles.tile_begin(tile); k < particles.tile_begin(tile + 1); ++k)
        set_linear<PlaneStrain, decltype(shape)>(frame, g, tile, particles.order(k), particles);
  });
  advance_to(scene, 1.0, state, 1);
  double largest = 0.0;
  for (int p = 0; p < particles.count; ++p) {
    const double x = particles.position(p, 0), y = particles.position(p, 1);
    if (std::abs(x) > 1.5 || std::abs(y) > 1.5) continue;
    for (int i = 0; i < 2; ++i)
      largest = std::max(largest, std::abs(particles.velocity(p, i) - g[i][0] * x - g[i][1] * y));
  }
  return largest;
}

TEST(TransferMotions, LinearVelocitiesStayInsideABody) {
  for (const std::string& shape : all_shapes())
    for (const StepCase& one : all_steps(shape)) {
      SCOPED_TRACE(one.name);
      EXPECT_LT(change_of_linear_field(one.step, 0.0), 1e-12);
    }
}

TEST(TransferMotions, ApicKeepsThemOnScatteredParticlesToo) {
  for (const std::string& shape : all_shapes())
    for (const StepCase& one : all_steps(shape)) {
      SCOPED_TRACE(one.name);
      const double change = change_of_linear_field(one.step, 0.07);
      if (one.step.transfer == Transfer::apic) {
        EXPECT_LT(change, 1e-12);
      } else if (one.step.pic_fraction == 1.0) {
        EXPECT_GT(change, 1e-4);
      }
    }
}

/// What is left after some steps of the energy of a shear wave of eight cells that no stress
/// drives.
double energy_left(const StepSpec& step) {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0, 0.0}, {24.0, 24.0, 0.0}, testing::elastic(1e-6, 0.3, 1.0)
  );
  scene.step = step;
  scene.step.largest_step = 1e-6;
  BodySpec& body = add_box(scene, "box", {2.0, 2.0, 0.0}, {22.0, 22.0, 0.0}, 2);
  body.velocity = {0.0, 1.0, 0.0};
  body.velocity_wave_number = {0.78539816, 0.0, 0.0};
  State state = start_alone(scene);
  const double before = state.ledger.initial_kinetic;
  advance_to(scene, 1.0, state, 5);
  return state.ledger.kinetic / before;
}

TEST(TransferMotions, TheHigherTheOrderOfXpicTheLessItLoses) {
  for (const std::string& shape : all_shapes())
    for (const Order order :
         {Order::stress_last, Order::modified_stress_last, Order::stress_first}) {
      SCOPED_TRACE(shape + ", " + word_of(order));
      StepSpec step;
      step.shape = shape;
      step.order = order;
      const double flip = energy_left(step);
      EXPECT_NEAR(flip, 1.0, 1e-10);
      step.pic_fraction = 1.0;
      double last = energy_left(step);
      EXPECT_LT(last, 0.95);
      step.pic_fraction = 0.0;
      step.transfer = Transfer::xpic;
      for (step.xpic_order = 2; step.xpic_order <= 5; ++step.xpic_order) {
        const double left = energy_left(step);
        EXPECT_GT(left, last);
        last = left;
      }
      EXPECT_LT(last, flip);
      EXPECT_GT(last, 0.99);
    }
}

TEST(TransferMotions, OnlyWhatIsChosenCostsMemory) {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1.0, {0.0, 0.0, 0.0}, {4.0, 4.0, 0.0}, testing::elastic(1.0, 0.3, 1.0)
  );
  std::map<Transfer, std::size_t> bytes;
  for (const StepCase& one : all_transfers()) {
    scene.step = one.step;
    bytes[one.step.transfer] = bytes_per_particle(make_particles(scene, 0));
  }
  const std::size_t flip = bytes.at(Transfer::flip);
  EXPECT_EQ(bytes.at(Transfer::apic), flip + 4 * sizeof(double));
  EXPECT_EQ(bytes.at(Transfer::xpic), flip + (4 + 5 + 2) * sizeof(double));
  scene.step = {};
  scene.step.order = Order::stress_first;
  EXPECT_EQ(bytes_per_particle(make_particles(scene, 0)), flip + 4 * sizeof(double));
}

}  // namespace
}  // namespace barreno
