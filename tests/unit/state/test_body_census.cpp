// SPDX-License-Identifier: BSD-3-Clause
// Particles are made by the ranks that own them, with the ids and the bits of one walk over all,
// and what a rank looks at for that becomes less with their number.
#include "base/work_counts.hpp"
#include "scene/tile_levels.hpp"
#include "support/scenes.hpp"

#include <Tpetra_Core.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace barreno {
namespace {

Teuchos::RCP<const Comm> all_ranks() {
  return Tpetra::getDefaultComm();
}

void add_body(Scene& scene, const std::string& name, const Shape& shape, int particles_per_cell) {
  testing::add_box(scene, name, {}, {}, particles_per_cell).shape = shape;
}

/// A block, a shell and a drilled block; faces of the block carry loads.
Scene three_bodies() {
  constexpr double h = 2e-3;
  Scene scene = testing::box_scene(
      Mode::three_dimensional, h, {}, {0.032, 0.024, 0.04}, testing::elastic(1e9, 0.3, 1e3)
  );
  testing::add_box(scene, "block", {0.0, 0.0, 0.0}, {0.032, 0.0075, 0.04}, 2);
  add_body(scene, "shell", Ball{{0.0165, 0.016, 0.0123}, 0.0078, 0.0041}, 2);
  const Cone bore{{0.016, 0.01, 0.03}, {0.016, 0.03, 0.03}, 0.0031, 0.0031};
  const Box around{{0.0083, 0.0101, 0.0212}, {0.0257, 0.0219, 0.0383}};
  add_body(scene, "drilled", Combination{Operation::subtract, {around, bore}}, 3);
  return scene;
}

Scene refined_bodies() {
  Scene scene = three_bodies();
  scene.grid.level_of_tile =
      find_cheapest_levels(scene.grid, {{Box{{0.012, 0.0, 0.0}, {0.02, 0.02, 0.02}}, 1}});
  return scene;
}

/// Place, sizes and volume of the particles with an id.
using Made = std::map<ParticleId, std::vector<double>>;

std::vector<double> values_of(const NewParticle& p) {
  return {p.x[0], p.x[1], p.x[2], p.half[0], p.half[1], p.half[2], p.volume};
}

/// By a walk over all.
Made walk(const Scene& scene, std::vector<long long>& counts) {
  Made made;
  ParticleId first = 1;
  for (const BodySpec& body : scene.bodies) {
    long long count = 0;
    for_each_body_particle(scene.grid, body, first, [&](const NewParticle& p) {
      EXPECT_TRUE(made.emplace(p.id, values_of(p)).second);
      ++count;
    });
    counts.push_back(count);
    first += count;
  }
  return made;
}

std::vector<double> values_of(const Particles& particles, int p) {
  const Vector x = vector_of(particles.position, p), half = vector_of(particles.half_size, p);
  return {x[0], x[1], x[2], half[0], half[1], half[2], particles.volume(p)};
}

void expect_in_parcels(const Made& made, const Grid& grid, const BodyCensus& census) {
  std::vector<double> in_parcels(census.parcels.size(), 0.0);
  for (const auto& [id, values] : made) {
    const int tile = cell_of(grid, {values[0], values[1], values[2]}).box_tile;
    in_parcels[static_cast<std::size_t>(grid.parcels.holding(tile))] += 1.0;
  }
  for (std::size_t i = 0; i < in_parcels.size(); ++i)
    EXPECT_EQ(census.parcels[i].particles, in_parcels[i]) << i;
}

class BodyCensusTest : public ::testing::TestWithParam<Scene (*)()> {};

TEST_P(BodyCensusTest, CountsWhatAWalkFinds) {
  const Scene scene = GetParam()();
  const auto comm = all_ranks();
  const BodyCensus census = take_census(scene, comm);
  std::vector<long long> counts;
  const Made made = walk(scene, counts);
  EXPECT_EQ(census.counts, counts);
  EXPECT_EQ(census.first.back(), static_cast<ParticleId>(made.size()) + 1);
  expect_in_parcels(made, build_state(scene, census, comm).grid, census);
}

TEST_P(BodyCensusTest, CountsParcelsOfManyTiles) {
  Scene scene = GetParam()();
  scene.grid.most_parcels = 9;
  const auto comm = all_ranks();
  const BodyCensus census = take_census(scene, comm);
  EXPECT_LE(census.parcels.size(), 9U);
  std::vector<long long> counts;
  const Made made = walk(scene, counts);
  const State state = build_state(scene, census, comm);
  expect_in_parcels(made, state.grid, census);
  std::vector<long long> sum{0};
  for (const Particles& particles : state.particles) {
    sum[0] += particles.count;
    for (int p = 0; p < particles.count; ++p)
      EXPECT_EQ(values_of(particles, p), made.at(particles.id(p)));
  }
  sum_over_ranks(*comm, sum);
  EXPECT_EQ(sum[0], static_cast<long long>(made.size()));
}

TEST_P(BodyCensusTest, EveryRankMakesThoseOfItsTilesToTheBit) {
  const Scene scene = GetParam()();
  const State state = build_state(scene, all_ranks());
  std::vector<long long> counts;
  const Made made = walk(scene, counts);
  std::vector<long long> sum{0};
  for (const Particles& particles : state.particles)
    for (int p = 0; p < particles.count; ++p) {
      ++sum[0];
      const auto found = made.find(particles.id(p));
      ASSERT_NE(found, made.end());
      EXPECT_EQ(values_of(particles, p), found->second);
      EXPECT_EQ(owner_of(state.grid, vector_of(particles.position, p)), state.grid.comm->getRank());
      const int body = particles.body(p);
      EXPECT_LT(
          particles.id(p), 1 + counts[0] + (body > 0 ? counts[1] : 0) + (body > 1 ? counts[2] : 0)
      );
    }
  sum_over_ranks(*all_ranks(), sum);
  EXPECT_EQ(sum[0], static_cast<long long>(made.size()));
}

TEST_P(BodyCensusTest, ARankLooksAtItsShareOfThePlaces) {
  const Scene scene = GetParam()();
  const auto comm = all_ranks();
  const auto looked_at = [](const auto& work) {
    const long long before = work_counts().candidate_points;
    work();
    return work_counts().candidate_points - before;
  };
  std::vector<long long> counts;
  const long long one_walk =
      looked_at([&] { walk(scene, counts); }) + counts[0];  // boxes do not count themselves there
  const long long made_before = work_counts().particles_made;
  std::vector<long long> most{looked_at([&] { build_state(scene, comm); })};
  std::vector<long long> made{work_counts().particles_made - made_before};
  max_over_ranks(*comm, most);
  max_over_ranks(*comm, made);
  const double ranks = comm->getSize();
  if (comm->getRank() == 0)
    std::cout << ranks << " ranks: one walk " << one_walk << ", largest rank " << most[0]
              << " looked at, " << made[0] << " made\n";
  // A census and the making, each of an equal share, and a little more at the surfaces.
  EXPECT_LT(static_cast<double>(most[0]), 2.5 * static_cast<double>(one_walk) / ranks);
  const auto particles = static_cast<double>(counts[0] + counts[1] + counts[2]);
  EXPECT_LT(static_cast<double>(made[0]), 1.5 * particles / ranks);
}

INSTANTIATE_TEST_SUITE_P(Grids, BodyCensusTest, ::testing::Values(&three_bodies, &refined_bodies));

}  // namespace
}  // namespace barreno
