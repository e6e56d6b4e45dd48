// SPDX-License-Identifier: BSD-3-Clause
// The answer does not depend on the order of particles, the decomposition or the units.
#include "barreno/models.hpp"
#include "barreno/registry.hpp"
#include "grid/partition.hpp"
#include "scene/tile_levels.hpp"
#include "shape/visit_kernels.hpp"
#include "state/balance.hpp"
#include "step/ranks/place_particles.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <numeric>
#include <sstream>
#include <vector>

namespace barreno {
namespace {

using testing::add_box;
using testing::add_symmetry;
using testing::advance_to;
using testing::all_rows;
using testing::box_scene;
using testing::is_alone;
using testing::on_root;
using testing::start;
using testing::start_alone;

/// Copper rod into a copper block: shock, plastic flow, contact, particles that change tiles and
/// ranks.
Scene impact(double length = 1.0, double time = 1.0, double mass = 1.0) {
  Material material = testing::copper().material();
  JohnsonCook::Parameters p = std::get<JohnsonCook>(material.model).parameters();
  const double stress = mass / (length * time * time);
  const double speed = length / time;
  p.shear_modulus *= stress;
  p.a *= stress;
  p.b *= stress;
  p.reference_rate /= time;
  p.specific_heat *= speed * speed;
  p.sound_speed *= speed;
  const double density = 8930.0 * mass / (length * length * length);
  material = {"copper", density, JohnsonCook(p, density)};

  Scene scene = box_scene(
      Mode::axisymmetric,
      1e-3 * length,
      {0.0, 0.0, 0.0},
      {0.024 * length, 0.040 * length, 0.0},
      material
  );
  const auto box = [&](const char* name, double r, double z0, double z1) -> BodySpec& {
    return add_box(scene, name, {0.0, z0 * length, 0.0}, {r * length, z1 * length, 0.0}, 2);
  };
  box("rod", 0.0041, 0.004, 0.0159).velocity = {0.0, 1500.0 * speed, 0.0};
  box("block", 0.0172, 0.0163, 0.0307);
  add_symmetry(scene, Face::x_lower);
  return scene;
}

const std::string cards = BARRENO_SOURCE_DIR "/materials/cards/";

/// The same with a block of sandstone, whose points share vector lanes while they flow.
Scene impact_on_rock() {
  Scene scene = impact();
  scene.materials.emplace_back(read_card(cards + "berea_sandstone.xml"), BadParticlePolicy::hold);
  scene.bodies[1].material = 1;
  return scene;
}

/// A copper bar that flies into the corner of a block: shock, plastic flow and turning in space.
Scene impact_in_space() {
  Scene scene = box_scene(
      Mode::three_dimensional, 1e-3, {-0.002, 0.0, 0.0}, {0.014, 0.024, 0.013}, testing::copper()
  );
  add_box(scene, "bar", {0.0, 0.003, 0.001}, {0.0041, 0.0089, 0.0052}, 2).velocity = {
      200.0, 1500.0, 100.0};
  add_box(scene, "block", {0.0022, 0.0093, 0.0}, {0.0112, 0.0152, 0.0071}, 2);
  add_symmetry(scene, Face::z_lower);
  return scene;
}

/// With cells half as wide where they meet, whose particles move on into larger ones.
Scene impact_on_levels(Scene scene) {
  const RefinedRegion region{Box{{0.0, 0.014, 0.0}, {0.006, 0.018, 0.004}}, 1};
  scene.grid.level_of_tile = find_tile_levels(scene.grid, {region});
  return scene;
}

/// The same in a strip so narrow that tiles are half as large.
Scene impact_in_a_strip(Scene scene) {
  const RefinedRegion region{Box{{0.0, 0.0, 0.0}, {0.004, 0.1, 0.0}}, 1};
  scene.grid.level_of_tile = find_cheapest_levels(scene.grid, {region});
  EXPECT_EQ(tile_size_of(scene.grid), 4.0 * scene.grid.cell_size);
  return scene;
}

constexpr double end_time = 6e-6;

Scene with_shape(Scene scene, const std::string& word) {
  scene.step.shape = word;
  return scene;
}

/// A card of the project with a fluid in the pores and strength that scatters.
Material wet_scattered_rock(const std::string& card) {
  std::ifstream file(cards + card);
  std::ostringstream text;
  text << file.rdbuf();
  Teuchos::ParameterList list = scan_card(text.str(), card);
  list.set("fluid_B0", 2.2e9);
  list.set("Weibull modulus", 4.0);
  list.set("Weibull reference volume", 1e-6);
  return make_material("sandstone", list);
}

/// Wet sandstone whose strength scatters, thrown at itself.
Scene scattered_rock() {
  Scene scene = box_scene(
      Mode::axisymmetric,
      1e-3,
      {0.0, 0.0, 0.0},
      {0.024, 0.040, 0.0},
      MaterialSpec(wet_scattered_rock("arenisca_demonstration.xml"))
  );
  add_box(scene, "ball", {0.0, 0.004, 0.0}, {0.0041, 0.0159, 0.0}, 2).velocity = {0, 500.0, 0};
  add_box(scene, "block", {0.0, 0.0163, 0.0}, {0.0172, 0.0307, 0.0}, 2);
  add_symmetry(scene, Face::x_lower);
  return scene;
}

/// Largest difference of two results, column by column relative to the column's own size.
double difference(
    const std::vector<std::vector<double>>& a, const std::vector<std::vector<double>>& b
) {
  EXPECT_EQ(a.size(), b.size());
  const std::size_t columns = a.empty() ? 0 : a.front().size();
  std::vector<double> size(columns, 0.0);
  std::vector<double> worst(columns, 0.0);
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    for (std::size_t c = 0; c < columns; ++c) {
      size[c] = std::max(size[c], std::abs(a[i][c]));
      worst[c] = std::max(worst[c], std::abs(a[i][c] - b[i][c]));
    }
  double largest = 0.0;
  for (std::size_t c = 0; c < columns; ++c)
    if (size[c] > 0.0) largest = std::max(largest, worst[c] / size[c]);
  return largest;
}

/// All terms of the ledger, and those of its materials: they are sums over particles and nodes.
std::vector<double> numbers_of(const Ledger& ledger) {
  using Terms = LedgerTerms<double>;
  std::vector<double> numbers(sizeof(Terms) / sizeof(double));
  std::memcpy(numbers.data(), static_cast<const Terms*>(&ledger), sizeof(Terms));
  numbers.push_back(ledger.retried_steps);
  for (const auto& [prestress, elastic, plastic, viscous, explosive] : ledger.materials)
    for (const double energy : {prestress, elastic, plastic, viscous, explosive})
      numbers.push_back(energy);
  return numbers;
}

void expect_same_ledger(const Ledger& a, const Ledger& b) {
  EXPECT_NE(a.elastic + a.plastic, 0.0);
  EXPECT_NE(a.transfer, 0.0);
  const std::vector<double> of_a = numbers_of(a), of_b = numbers_of(b);
  ASSERT_EQ(of_a.size(), of_b.size());
  for (std::size_t i = 0; i < of_a.size(); ++i) EXPECT_EQ(of_a[i], of_b[i]) << "term " << i;
}

/// Of all ranks of a run.
Ledger ledger_of(const State& state) {
  return sum_over_ranks(*state.grid.comm, state.ledger);
}

/// The same particles and the same sums over them, bit for bit.
void expect_same(const State& one, const State& other) {
  EXPECT_EQ(difference(all_rows(one), all_rows(other)), 0.0);
  expect_same_ledger(ledger_of(one), ledger_of(other));
}

/// Reverse the rows of every set as they are stored.
void reverse_rows(State& state) {
  for (Particles& particles : state.particles) {
    for (int k = 0; k < particles.count; ++k)
      particles.order(static_cast<std::size_t>(k)) = particles.count - 1 - k;
    permute_rows(particles);
    particles.sorted = false;
  }
}

/// With tiles that take steps of their own, up to eight times as long as the smallest.
Scene with_subcycles(Scene scene) {
  scene.step.subcycles = 8;
  return scene;
}

void expect_same_when_shuffled(const Scene& scene) {
  State straight = start(scene);
  advance_to(scene, end_time, straight);
  State shuffled = start(scene);
  reverse_rows(shuffled);
  advance_to(scene, end_time / 2.0, shuffled, scene.step.subcycles > 1 ? 5 : 20);
  reverse_rows(shuffled);
  advance_to(scene, end_time, shuffled);
  EXPECT_GT(straight.clock.step, scene.step.subcycles > 1 ? 10 : 55);
  expect_same(straight, shuffled);
}
TEST(SameAnswer, ShuffledParticlesGiveTheSameBits) {
  expect_same_when_shuffled(impact());
}
TEST(SameAnswer, ShuffledParticlesGiveTheSameBitsInSpace) {
  expect_same_when_shuffled(impact_in_space());
}
TEST(SameAnswer, ShuffledParticlesGiveTheSameBitsWithEveryShapeFunction) {
  for_each_shape([](auto shape) {
    SCOPED_TRACE(decltype(shape)::word);
    expect_same_when_shuffled(with_shape(impact(), decltype(shape)::word));
  });
}
TEST(SameAnswer, ShuffledParticlesGiveTheSameBitsOnLevels) {
  expect_same_when_shuffled(impact_on_levels(impact()));
}
TEST(SameAnswer, ShuffledParticlesGiveTheSameBitsInRock) {
  expect_same_when_shuffled(impact_on_rock());
}
TEST(SameAnswer, ShuffledParticlesGiveTheSameBitsWithSubcycles) {
  expect_same_when_shuffled(with_subcycles(impact_on_levels(impact_on_rock())));
}

/// Rows of rock with an equivalent plastic strain above 1e-3.
int count_flowed(const Particles& rock) {
  int flowed = 0;
  for (int p = 0; p < rock.count; ++p) flowed += rock.history(p, 1) > 1e-3 ? 1 : 0;
  return flowed;
}

/// The root repeats the run alone: with 2 and 4 ranks this compares rank counts.
void expect_same_alone(const Scene& scene) {
  State together = start(scene);
  advance_to(scene, end_time, together);
  const auto rows = all_rows(together);
  const Ledger ledger = ledger_of(together);
  on_root([&] {
    State alone = start_alone(scene);
    advance_to(scene, end_time, alone);
    EXPECT_EQ(difference(all_rows(alone), rows), 0.0);
    expect_same_ledger(ledger_of(alone), ledger);
    if (scene.materials.size() > 1) {
      EXPECT_GT(count_flowed(alone.particles[1]), 200);
    }
  });
}
TEST(SameAnswer, AnyRankCountGivesTheSameBits) {
  expect_same_alone(impact());
}
TEST(SameAnswer, AnyRankCountGivesTheSameBitsInSpace) {
  expect_same_alone(impact_in_space());
}
TEST(SameAnswer, AnyRankCountGivesTheSameBitsWithEveryShapeFunction) {
  if (is_alone()) GTEST_SKIP() << "compares rank counts";
  for_each_shape([](auto shape) {
    SCOPED_TRACE(decltype(shape)::word);
    expect_same_alone(with_shape(impact(), decltype(shape)::word));
    expect_same_alone(with_shape(impact_in_space(), decltype(shape)::word));
  });
}
TEST(SameAnswer, AnyRankCountGivesTheSameBitsOnLevelsWithEveryShapeFunction) {
  if (is_alone()) GTEST_SKIP() << "compares rank counts";
  for_each_shape([](auto shape) {
    SCOPED_TRACE(decltype(shape)::word);
    expect_same_alone(impact_on_levels(with_shape(impact(), decltype(shape)::word)));
  });
}
/// Of two cells to either side, so that patches reach over more than one tile.
TEST(SameAnswer, AnyRankCountGivesTheSameBitsOnSmallTiles) {
  expect_same_alone(impact_in_a_strip(with_shape(impact(), "cubic B-spline")));
}
TEST(SameAnswer, AnyRankCountGivesTheSameBitsOnLevelsInSpace) {
  expect_same_alone(impact_on_levels(impact_in_space()));
}
/// Domains of several cells: patches that reach over more than one tile.
TEST(SameAnswer, AnyRankCountGivesTheSameBitsWithLargeDomains) {
  Scene scene = with_shape(impact(), "CPDI");
  scene.step.largest_domain = farthest_domain(scene.grid.mode);
  expect_same_alone(scene);
}
TEST(SameAnswer, AnyRankCountGivesTheSameBitsInRock) {
  expect_same_alone(impact_on_rock());
}
TEST(SameAnswer, AnyRankCountGivesTheSameBitsWithSubcycles) {
  expect_same_alone(with_subcycles(impact_on_rock()));
}
TEST(SameAnswer, AnyRankCountGivesTheSameBitsWithSubcyclesOnLevels) {
  expect_same_alone(with_subcycles(impact_on_levels(impact_on_rock())));
}
TEST(SameAnswer, AnyRankCountGivesTheSameBitsWithSubcyclesOnSmallTiles) {
  expect_same_alone(with_subcycles(impact_in_a_strip(impact_on_rock())));
}
TEST(SameAnswer, AnyRankCountGivesTheSameBitsWithSubcyclesOnLevelsInSpace) {
  expect_same_alone(with_subcycles(impact_on_levels(impact_in_space())));
}

/// The specimen too: strengths come from the ids of particles.
int history_index(const Material& material, const std::string& name) {
  return std::visit(
      [&](const auto& model) {
        const auto table = std::decay_t<decltype(model)>::history_table();
        const auto found = std::find_if(table.begin(), table.end(), [&](const HistoryField& field) {
          return field.name == name;
        });
        EXPECT_NE(found, table.end()) << name;
        return static_cast<int>(found - table.begin());
      },
      material.model
  );
}

TEST(SameAnswer, ScatteredRockIsTheSameForAnyRankCount) {
  const Scene scene = scattered_rock();
  State together = start(scene), alone = start_alone(scene);
  double weakest = HUGE_VAL, strongest = 0.0;
  const Particles& rock = alone.particles.front();
  const int coherence = history_index(scene.materials.front().material(), "coherence");
  for (int p = 0; p < rock.count; ++p) {
    weakest = std::min(weakest, rock.history(p, coherence));
    strongest = std::max(strongest, rock.history(p, coherence));
  }
  EXPECT_GT(strongest / weakest, 3.0);
  advance_to(scene, end_time, together);
  advance_to(scene, end_time, alone);
  expect_same(alone, together);
}

void expect_same_when_moved(const Scene& scene) {
  State balanced = start(scene);
  advance_to(scene, end_time, balanced);
  State moved = start(scene);
  advance_to(scene, end_time, moved, scene.step.subcycles > 1 ? 5 : 20);
  std::vector<ParcelCost> costs(moved.grid.owner.size(), {1.0, 0.0});
  for (std::size_t t = 0; t < costs.size(); t += 3) costs[t].particles = 4.0;
  give_parcels(
      bisect_parcels(moved.grid.parcels.along, costs, moved.grid.comm->getSize()),
      moved.clock.step,
      continuum_of(moved)
  );
  advance_to(scene, end_time, moved);
  expect_same(balanced, moved);
}
/// Ranks own squares of tiles instead of tiles.
Scene in_parcels(Scene scene, std::size_t most) {
  scene.grid.most_parcels = most;
  return scene;
}
TEST(SameAnswer, ParcelsOfSeveralTilesGiveTheSameBits) {
  const Scene scene = in_parcels(impact(), 6);
  EXPECT_GT(start(scene).grid.parcels.bits, 0);
  State parcels = start(scene), tiles = start(impact());
  advance_to(scene, end_time, parcels);
  advance_to(impact(), end_time, tiles);
  expect_same(tiles, parcels);
  expect_same_when_moved(in_parcels(impact_on_levels(impact()), 6));
}

TEST(SameAnswer, AnotherDecompositionGivesTheSameBits) {
  expect_same_when_moved(impact());
}
TEST(SameAnswer, AnotherDecompositionGivesTheSameBitsOnLevels) {
  expect_same_when_moved(impact_on_levels(impact()));
}
TEST(SameAnswer, AnotherDecompositionGivesTheSameBitsInSpace) {
  expect_same_when_moved(impact_in_space());
}
TEST(SameAnswer, AnotherDecompositionGivesTheSameBitsWithCpdi) {
  expect_same_when_moved(with_shape(impact(), "CPDI"));
}
TEST(SameAnswer, AnotherDecompositionGivesTheSameBitsInRock) {
  expect_same_when_moved(impact_on_rock());
}
TEST(SameAnswer, AnotherDecompositionGivesTheSameBitsWithSubcycles) {
  expect_same_when_moved(with_subcycles(impact_on_levels(impact_on_rock())));
}

/// The whole problem in other units, powers of two so that scaling itself rounds nothing: only the
/// library functions of strain, rate and temperature, which are dimensionless, can differ.
void expect_same_in_units(const std::string& shape) {
  const double length = 1024.0;
  const double time = 1.0 / 4096.0;
  const double mass = 64.0;
  const Scene metres = with_shape(impact(), shape);
  const Scene other = with_shape(impact(length, time, mass), shape);
  State a = start(metres);
  State b = start(other);
  advance_to(metres, end_time, a);
  advance_to(other, end_time * time, b);
  EXPECT_EQ(a.clock.step, b.clock.step);
  auto rows = all_rows(b);
  const double stress = mass / (length * time * time);
  const double scale[9] = {
      length, length, length / time, length / time, stress, stress, stress, stress, 1.0};
  for (auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) row[c] /= scale[c];
  EXPECT_LT(difference(all_rows(a), rows), 1e-9);
}
TEST(SameAnswer, TwoUnitSystemsGiveTheSameDigits) {
  for_each_shape([](auto shape) {
    SCOPED_TRACE(decltype(shape)::word);
    expect_same_in_units(decltype(shape)::word);
  });
}

}  // namespace
}  // namespace barreno
