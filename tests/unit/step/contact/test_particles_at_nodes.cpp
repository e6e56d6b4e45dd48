// SPDX-License-Identifier: BSD-3-Clause
// The particles that the nodes of a tile get something from, those of finer tiles included.
#include "grid/tiles.hpp"
#include "scene/tile_levels.hpp"
#include "shape/visit_kernels.hpp"
#include "step/contact/particles_at_nodes.hpp"
#include "step/prepare_step.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <array>

namespace barreno {
namespace {

/// A block in cells of three sizes.
State refined_block(Mode mode) {
  Scene scene = testing::box_scene(
      mode, 1e-3, {0.0, 0.0, 0.0}, {0.024, 0.024, 0.012}, testing::elastic(70e9, 0.3, 2700.0)
  );
  testing::add_box(scene, "block", {0.004, 0.003, 0.002}, {0.019, 0.021, 0.008}, 2);
  const int level = mode == Mode::three_dimensional ? 1 : 2;
  scene.grid.level_of_tile =
      find_tile_levels(scene.grid, {{Box{{0.009, 0.009, 0.0}, {0.012, 0.012, 0.003}}, level}});
  State state = testing::start_alone(scene);
  prepare_step(scene, 1.0, state);
  set_tile_steps(state.grid, 1e-8);
  return state;
}

/// Weights of the particles at all unknowns, and their first moments about the origin [cells of
/// level 0].
template <class M, class S>
std::array<double, 3> sums_at_unknowns(const State& state) {
  const Grid& grid = state.grid;
  ArrayView<unsigned char> all("passes_up", static_cast<std::size_t>(grid.active));
  Kokkos::deep_copy(all, 1);
  const ParticlesAtNodes<M, S> particles(grid, all, state.particles[0]);
  std::array<double, 3> sums{};
  for (int tile = 0; tile < grid.active; ++tile) {
    const TilePosition at = grid.tile_frame(tile).position;
    const double cell = 1.0 / (1 << at.level);
    particles.for_each(tile, [&](const auto& ellipse, int slot, double weight) {
      if (at.level > 0 && grid.from_parent(tile * grid.patch.size + slot) != 0) return;
      sums[0] += weight;
      for (int d = 0; d < 2; ++d)
        sums[1 + static_cast<std::size_t>(d)] +=
            weight * cell * (ellipse.x[d] + at[d] * grid.patch.tile_cells - grid.patch.reach);
    });
  }
  return sums;
}

/// Each is given once, whole, and at the place where it is.
TEST(ParticlesAtNodes, AreGivenWholeAndInPlaceWhateverTheCells) {
  for (const Mode mode : testing::all_modes) {
    const State state = refined_block(mode);
    const Particles& particles = state.particles[0];
    std::array<double, 3> expected{static_cast<double>(particles.count), 0.0, 0.0};
    for (int p = 0; p < particles.count; ++p)
      for (int d = 0; d < 2; ++d)
        expected[1 + static_cast<std::size_t>(d)] += particles.position(p, d) / 1e-3;
    ASSERT_TRUE(state.grid.is_refined());
    visit_kernels(state.grid, [&](auto mode_type, auto shape) {
      const auto found = sums_at_unknowns<decltype(mode_type), decltype(shape)>(state);
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i] / expected[i], 1.0, 1e-12);
    });
  }
}

}  // namespace
}  // namespace barreno
