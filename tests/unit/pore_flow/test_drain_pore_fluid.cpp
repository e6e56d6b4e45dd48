// SPDX-License-Identifier: BSD-3-Clause
#include "base/gather.hpp"
#include "pore_flow/drain_pore_fluid.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <barreno/models.hpp>
#include <cmath>
#include <limits>

namespace barreno {
namespace {

using namespace testing;

constexpr double biot = 7.0 / 9.0, porosity = 0.19;
constexpr double storage = porosity / 2.25e9 + (biot - porosity) / 36e9;

Material berea() {
  Poroelastic::Parameters p{8e9, 6e9, porosity, 2.25e9};
  p.grain_bulk_modulus = 36e9;
  return {"Rock", 2300.0, Poroelastic(p, 2300.0)};
}

/// A block of rock of n cells along each axis with a free cell around it, that drains over dt
/// without having moved.
Scene block_scene(Mode mode, int n, double permeability) {
  const double side = n;
  Scene scene = box_scene(mode, 1.0, {0, 0, 0}, {side + 1, side + 1, side + 1}, berea());
  add_box(scene, "Block", {0, 0, 0}, {side, side, side}, 2);
  scene.pore_flow.drainage = Drainage::on;
  scene.pore_flow.viscosity = 1e-3;
  scene.pore_flow.rocks = {{{permeability, permeability, permeability}, false}};
  scene.end_time = 1.0;
  return scene;
}

PoreConditionSpec open_on_top() {
  PoreConditionSpec condition;
  condition.open_faces[static_cast<std::size_t>(Face::y_upper)] = true;
  return condition;
}

constexpr std::size_t pressure = 0;  // of Poroelastic::History

std::string drain(const Scene& scene, double dt, State& state) {
  return drain_pore_fluid(porous_medium(scene, state), dt, state.pore_flow, state.ledger);
}

template <class PressureAt>
void set_pressures(State& state, PressureAt&& at) {
  Particles& rock = state.particles[0];
  for (int p = 0; p < rock.count; ++p) rock.history(p, pressure) = at(vector_of(rock.position, p));
}

/// The solve waits for sorted rows, which the first step makes.
State placed(const Scene& scene) {
  State state = start(scene);
  Scene still = scene;
  still.pore_flow.drainage = Drainage::off;
  advance_to(still, 1e-30, state, 1);
  return state;
}

double fluid(const State& state) {
  const Particles& rock = state.particles[0];
  std::array<double, 1> sum{};
  for (int p = 0; p < rock.count; ++p) sum[0] += rock.volume(p) * rock.history(p, 1);
  sum_over_ranks(*state.grid.comm, sum);
  return sum[0];
}

/// Two sums over all particles: each is off by half a round-off per term at most.
double round_off(const State& state) {
  std::array<double, 1> terms{static_cast<double>(state.particles[0].count)};
  sum_over_ranks(*state.grid.comm, terms);
  return terms[0] * std::numeric_limits<double>::epsilon();
}

TEST(DrainPoreFluid, WithoutPermeabilityChangesNoBit) {
  for (const Mode mode : all_modes) {
    Scene scene = block_scene(mode, 4, 0.0);
    scene.pore_flow.conditions = {open_on_top()};
    State state = placed(scene);
    set_pressures(state, [](const Vector& x) { return 1e6 * std::sin(x[0] + 2.0 * x[1]); });
    const Particles& rock = state.particles[0];
    std::vector<double> before;
    for (int p = 0; p < rock.count; ++p)
      for (int c = 0; c < rock.stress.components; ++c) before.push_back(rock.stress(p, c));
    std::vector<double> pressures(static_cast<std::size_t>(rock.count));
    for (int p = 0; p < rock.count; ++p)
      pressures[static_cast<std::size_t>(p)] = rock.history(p, pressure);
    drain(scene, 1.0, state);
    EXPECT_EQ(state.pore_flow.solves, 1);
    std::size_t k = 0;
    for (int p = 0; p < rock.count; ++p) {
      EXPECT_EQ(rock.history(p, pressure), pressures[static_cast<std::size_t>(p)]);
      for (int c = 0; c < rock.stress.components; ++c) EXPECT_EQ(rock.stress(p, c), before[k++]);
    }
  }
}

/// Sealed all around, whatever the fluid does, its mass stays; in the end it is everywhere under
/// one pressure, but for the 1 / (1 + c dt (pi / L)^2) that backward Euler leaves, and total stress
/// has followed by alpha dp.
TEST(DrainPoreFluid, SealedRockKeepsItsFluid) {
  for (const Mode mode : all_modes) {
    Scene scene = block_scene(mode, 4, 1e-12);
    State state = placed(scene);
    set_pressures(state, [](const Vector& x) { return x[1] < 1.7 ? 1e6 : 0.0; });
    const double before = fluid(state);
    double mean = 0.0, volume = 0.0;
    const Particles& rock = state.particles[0];
    for (int p = 0; p < rock.count; ++p) {
      mean += rock.volume(p) * rock.history(p, pressure);
      volume += rock.volume(p);
    }
    std::array<double, 2> sums{mean, volume};
    sum_over_ranks(*state.grid.comm, sums);
    const double stress = rock.count > 0 ? rock.stress(0, 0) : 0.0;
    const double first = rock.count > 0 ? rock.history(0, pressure) : 0.0;
    drain(scene, 1e5, state);
    EXPECT_NEAR(fluid(state) / before, 1.0, round_off(state));
    for (int p = 0; p < rock.count; ++p)
      EXPECT_NEAR(rock.history(p, pressure), sums[0] / sums[1], 1.5);  // 0.94 is what that leaves
    if (rock.count > 0) {
      EXPECT_NEAR(rock.stress(0, 0) - stress, -biot * (rock.history(0, pressure) - first), 1e-6);
    }
  }
}

/// What leaves with particles is told apart from what a solve loses.
TEST(DrainPoreFluid, CountsTheFluidOfRemovedParticles) {
  Scene scene = block_scene(Mode::plane_strain, 4, 1e-12);
  State state = placed(scene);
  set_pressures(state, [](const Vector&) { return 1e6; });
  drain(scene, 1e5, state);
  EXPECT_EQ(state.pore_flow.removed, 0.0);
  Particles& rock = state.particles[0];
  std::array<double, 1> gone{0.0};
  for (int p = 0; p < rock.count; ++p) {
    if (vector_of(rock.position, p)[1] > 1.0) continue;
    rock.body(p) |= debris_bit;
    gone[0] += porosity * rock.mass(p) / 2300.0 * rock.history(p, 1);
  }
  sum_over_ranks(*state.grid.comm, gone);
  const double before = state.pore_flow.fluid;
  drain(scene, 1e5, state);
  EXPECT_GT(gone[0], 0.0);
  EXPECT_NEAR(state.pore_flow.removed, gone[0], 1e-13 * before);
  EXPECT_NEAR(state.pore_flow.fluid + state.pore_flow.removed, before, 1e-13 * before);
}

/// Backward Euler over n layers by hand: what leaves a column at its open top.
TEST(DrainPoreFluid, IsBackwardEulerOfTheLayers) {
  constexpr int n = 4;
  constexpr double permeability = 1e-13, mobility = permeability / 1e-3;
  for (const Mode mode : all_modes) {
    Scene scene = block_scene(mode, n, permeability);
    scene.pore_flow.conditions = {open_on_top()};
    State state = placed(scene);
    set_pressures(state, [](const Vector&) { return 1e6; });
    const double dt = 0.7 * storage / mobility;
    // Thomas' algorithm is not needed for four layers: Gauss-Seidel to round-off.
    double p[n];
    std::fill(p, p + n, 1e6);
    for (int sweep = 0; sweep < 500; ++sweep)
      for (int j = 0; j < n; ++j) {
        const double up = j + 1 < n ? mobility : 2.0 * mobility, down = j > 0 ? mobility : 0.0;
        const double above = j + 1 < n ? p[j + 1] : 0.0, below = j > 0 ? p[j - 1] : 0.0;
        p[j] = (storage / dt * 1e6 + up * above + down * below) / (storage / dt + up + down);
      }
    const double before = fluid(state);
    drain(scene, dt, state);
    // The mean over a layer's particles, which are on a line through it.
    const Particles& rock = state.particles[0];
    std::array<double, 2 * n> sums{};
    for (int i = 0; i < rock.count; ++i) {
      const auto j = static_cast<std::size_t>(rock.position(i, 1));
      sums[j] += rock.volume(i) * rock.history(i, pressure);
      sums[n + j] += rock.volume(i);
    }
    sum_over_ranks(*state.grid.comm, sums);
    for (std::size_t j = 0; j < n; ++j) EXPECT_NEAR(sums[j] / sums[n + j], p[j], 1e-2);
    EXPECT_NEAR(before + state.pore_flow.inflow / porosity, fluid(state), 1e-14 * before);
    EXPECT_LT(state.pore_flow.inflow, 0.0);
  }
}

/// No pressure beyond those that were there, at any step.
TEST(DrainPoreFluid, NeverOvershoots) {
  for (const double number : {1e-3, 0.1, 1.0, 100.0, 1e6}) {
    Scene scene = block_scene(Mode::plane_strain, 6, 1e-12);
    scene.pore_flow.conditions = {open_on_top()};
    State state = placed(scene);
    set_pressures(state, [](const Vector&) { return 1e6; });
    const double dt = number * storage * 1e-3 / 1e-12;
    scene.pore_flow.diffusion_number = 1e-9;
    for (int step = 0; step < 20; ++step) drain(scene, dt, state);
    const Particles& rock = state.particles[0];
    for (int p = 0; p < rock.count; ++p) {
      EXPECT_LE(rock.history(p, pressure), 1e6 * (1.0 + 1e-3)) << number;
      EXPECT_GE(rock.history(p, pressure), -1e6 * 1e-3) << number;
    }
  }
}

/// Pressures so high that more than all fluid would leave: some cells are emptied, none loses more,
/// and what the rock lost has left.
TEST(DrainPoreFluid, TakesNoMoreThanPoresHold) {
  for (const Mode mode : all_modes) {
    Scene scene = block_scene(mode, 4, 1e-12);
    scene.pore_flow.conditions = {open_on_top()};
    State state = placed(scene);
    set_pressures(state, [](const Vector&) { return 3e9; });
    const double before = fluid(state);
    scene.pore_flow.diffusion_number = 1e-9;
    for (int solve = 0; solve < 40; ++solve) drain(scene, 0.1, state);
    EXPECT_EQ(state.pore_flow.solves, 40);
    const Particles& rock = state.particles[0];
    std::array<double, 1> least{0.0};
    for (int p = 0; p < rock.count; ++p) least[0] = std::max(least[0], -rock.history(p, 1));
    max_over_ranks(*state.grid.comm, least);
    EXPECT_EQ(least[0], 0.0);
    EXPECT_EQ(state.ledger.held, 0.0);
    EXPECT_NEAR(before + state.pore_flow.inflow / porosity, fluid(state), 1e-12 * before);
    EXPECT_LT(fluid(state), 0.01 * before);
  }
}

/// Fluid at rest under gravity stays at rest.
TEST(DrainPoreFluid, HydrostaticPressureIsRest) {
  Scene scene = block_scene(Mode::plane_strain, 5, 1e-12);
  scene.pore_flow.fluid_weight = {0.0, -1e4, 0.0};
  State state = placed(scene);
  const auto at_rest = [](const Vector& x) { return 1e4 * (5.0 - x[1]); };
  set_pressures(state, at_rest);
  drain(scene, 1e5, state);
  const Particles& rock = state.particles[0];
  for (int p = 0; p < rock.count; ++p)
    EXPECT_NEAR(rock.history(p, pressure), at_rest(vector_of(rock.position, p)), 1e-4);
}

}  // namespace
}  // namespace barreno
