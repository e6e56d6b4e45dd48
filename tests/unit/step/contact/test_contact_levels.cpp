// SPDX-License-Identifier: BSD-3-Clause
// Contact where cells have several sizes (docs/method.md 11), on any number of ranks.
#include "base/gather.hpp"
#include "scene/tile_levels.hpp"
#include "state/balance.hpp"
#include "support/expect_same_alone.hpp"
#include "unit/step/contact/oblique_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace barreno {
namespace {

using testing::add_box;
using testing::add_symmetry;
using testing::advance_to;
using testing::all_modes;
using testing::all_rows;
using testing::box_scene;
using testing::expect_same_alone;
using testing::is_alone;
using testing::oblique_blocks;
using testing::ObliqueBlocks;
using testing::start;

using Answer = std::vector<std::vector<double>>;

void refine(Scene& scene, const Box& box, int level) {
  scene.grid.level_of_tile = find_tile_levels(scene.grid, {{box, level}});
}

/// Blocks that meet at faces of cells of 2 mm, so that cells of half the size give the same
/// particles whether they are made by refinement or not.
ObliqueBlocks even_blocks() {
  return {
      {{0.004, 0.006, 0.002}, {0.012, 0.018, 0.006}},
      {{0.002, 0.018, 0.002}, {0.010, 0.030, 0.006}},
      {{0.010, 0.018, 0.002}, {0.014, 0.030, 0.006}}};
}

/// Numbers of the rows in the order of their places, which are the same in two runs to round-off.
std::vector<std::size_t> order_of_places(const Answer& rows, Mode mode) {
  const auto place = [&](std::size_t i) {
    const auto cell = [](double x) { return std::llround(x * 1e7); };
    const double z = mode == Mode::three_dimensional ? rows[i][9] : 0.0;
    return std::make_tuple(cell(rows[i][0]), cell(rows[i][1]), cell(z));
  };
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return place(a) < place(b);
  });
  return order;
}

class ContactLevels : public ::testing::TestWithParam<Mode> {};

/// Unknowns of the coarser lattices and of the finer ones together are those of the fine lattice:
/// normals, gaps and impulses must be those of the uniform grid.
TEST_P(ContactLevels, AGridThatIsRefinedEverywhereIsTheFineGrid) {
  const Mode mode = GetParam();
  const double h = mode == Mode::three_dimensional ? 2e-3 : 1e-3;
  const Scene fine = oblique_blocks(mode, h, 2, even_blocks());
  Scene refined = oblique_blocks(mode, 2.0 * h, 2, even_blocks());
  refine(refined, {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}}, 1);
  State expected = start(fine), found = start(refined);
  const Answer before_expected = all_rows(expected), before_found = all_rows(found);
  ASSERT_EQ(before_expected.size(), before_found.size());
  const auto first = order_of_places(before_expected, mode),
             second = order_of_places(before_found, mode);
  advance_to(fine, 8e-6, expected);
  advance_to(refined, 8e-6, found);
  EXPECT_NE(sum_over_ranks(*expected.grid.comm, expected.ledger).friction, 0.0);
  const Answer a = all_rows(expected), b = all_rows(found);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto &x = a[first[i]], &y = b[second[i]];
    for (const std::size_t d : {std::size_t{0}, std::size_t{1}}) EXPECT_NEAR(x[d], y[d], 1e-12);
    for (const std::size_t d : {std::size_t{2}, std::size_t{3}}) EXPECT_NEAR(x[d], y[d], 1e-7);
  }
}

/// Blocks that soon meet across the borders between cells of two and three sizes.
Scene across_borders(Mode mode) {
  const bool space = mode == Mode::three_dimensional;
  ObliqueBlocks blocks;
  for (Box* box : {&blocks.high, &blocks.beside}) {
    box->lower[1] = 0.0184;
    box->upper[1] = 0.0291;
  }
  Scene scene = oblique_blocks(mode, 2e-3, 2, blocks);
  refine(scene, {{0.004, 0.016, 0.002}, {0.007, 0.021, 0.004}}, space ? 1 : 2);
  return scene;
}

TEST_P(ContactLevels, KeepMassAndAxialMomentumAndTheEnergyLedgerCloses) {
  const Scene scene = across_borders(GetParam());
  State state = start(scene);
  advance_to(scene, 6e-6, state);
  const Ledger ledger = sum_over_ranks(*state.grid.comm, state.ledger);
  EXPECT_NEAR(mass_balance(ledger).error(), 0.0, 1e-14);
  EXPECT_NEAR(momentum_balance(ledger).error(), 0.0, 1e-13);
  EXPECT_NEAR(energy_balance(ledger).error(), 0.0, 1e-4);
  EXPECT_GT(ledger.elastic, 0.01 * ledger.initial_kinetic);
  EXPECT_NE(ledger.friction, 0.0);
}

TEST_P(ContactLevels, AnyRankCountGivesTheSameBits) {
  const Scene scene = across_borders(GetParam());
  if (is_alone()) GTEST_SKIP() << "compares rank counts";
  expect_same_alone(scene, [&](State& state) {
    advance_to(scene, 4e-6, state);
    EXPECT_NE(sum_over_ranks(*state.grid.comm, state.ledger).friction, 0.0);
  });
}

/// Blocks side by side whose faces touch: the first slides along the second through cells of three
/// sizes.
Scene sliding_blocks(Mode mode) {
  Scene scene = box_scene(
      mode, 1e-3, {0.0, 0.0, 0.0}, {0.024, 0.048, 0.0}, testing::elastic(70e9, 0.3, 2700.0)
  );
  scene.materials.push_back(scene.materials[0]);
  add_box(scene, "core", {0.0, 0.012, 0.0}, {0.007, 0.028, 0.0}, 2).velocity = {0.0, 100.0, 0.0};
  add_box(scene, "sleeve", {0.007, 0.008, 0.0}, {0.011, 0.022, 0.0}, 2).material = 1;
  scene.contacts.push_back({"faces", {0, 1}, ContactKind::frictionless, 0.0});
  add_symmetry(scene, Face::x_lower);
  refine(scene, {{0.006, 0.015, 0.0}, {0.008, 0.020, 0.0}}, 2);
  return scene;
}

/// Along a flat face the normals of all nodes are across it, whatever the cells, and nothing
/// pushes.
TEST(ContactOfFlatFaces, ExchangesNothingAcrossBordersOfCells) {
  if (!is_alone()) return;  // any rank count gives the same bits
  for (const Mode mode : {Mode::plane_strain, Mode::axisymmetric}) {
    const Scene scene = sliding_blocks(mode);
    State state = start(scene);
    advance_to(scene, 4e-6, state);
    EXPECT_GT(state.clock.step, 30);
    for (const auto& row : all_rows(state)) {
      EXPECT_NEAR(row[2], 0.0, 1e-9);
      EXPECT_NEAR(row[3] * (row[3] - 100.0), 0.0, 1e-7);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, ContactLevels, ::testing::ValuesIn(all_modes));

}  // namespace
}  // namespace barreno
