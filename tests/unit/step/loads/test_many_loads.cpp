// SPDX-License-Identifier: BSD-3-Clause
// A scene has as many loads as it wants: twenty of them push as one does.
#include "base/gather.hpp"
#include "checkpoint/read_checkpoint.hpp"
#include "checkpoint/write_checkpoint.hpp"
#include "state/build_state.hpp"
#include "state/load_table.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <utility>

namespace barreno {
namespace {

constexpr int columns = 20;
constexpr double h = 1e-3, pressure = 5e6, end = 4e-6;

PressureLoadSpec push_on(int body, double of) {
  PressureLoadSpec load;
  load.name = "push " + std::to_string(body);
  load.body = body;
  load.faces[static_cast<std::size_t>(Face::y_upper)] = true;
  load.pressure = {{0.0}, {of}};
  return load;
}

/// A slab that a pressure pushes down: of one body, or of columns side by side.
Scene slab(bool whole) {
  Scene scene = testing::box_scene(
      Mode::plane_strain,
      h,
      {-2.0 * h, 0.0, 0.0},
      {(columns + 2) * h, 8.0 * h, 0.0},
      testing::elastic(20e9, 0.25, 2300.0)
  );
  const int bodies = whole ? 1 : columns;
  const double width = whole ? columns * h : h;
  for (int b = 0; b < bodies; ++b) {
    testing::add_box(
        scene,
        "column " + std::to_string(b),
        {b * width, 2.0 * h, 0.0},
        {(b + 1) * width, 5.0 * h, 0.0},
        2
    );
    scene.loads.push_back(push_on(b, pressure));
  }
  return scene;
}

using Numbers = std::vector<std::vector<double>>;

/// Rows at the end, in the order of their places at the start.
Numbers rows_after(const Scene& scene) {
  State state = testing::start(scene);
  const Numbers first = testing::all_rows(state);
  testing::advance_to(scene, end, state);
  const Numbers last = testing::all_rows(state);
  std::vector<std::size_t> order(first.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto place = [&](std::size_t i) {
    return std::pair(std::lround(first[i][1] / (0.1 * h)), std::lround(first[i][0] / (0.1 * h)));
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return place(a) < place(b);
  });
  Numbers sorted;
  for (const std::size_t i : order) sorted.push_back(last[i]);
  return sorted;
}

void expect_same_motion(const Numbers& a, const Numbers& b) {
  ASSERT_EQ(a.size(), b.size());
  double fastest = 0.0;
  for (const auto& row : a) fastest = std::max(fastest, -row[3]);
  EXPECT_GT(fastest, 0.3 * pressure / (2300.0 * std::sqrt(24e9 / 2300.0)));
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(a[i][2], b[i][2], 1e-11 * fastest);
    EXPECT_NEAR(a[i][3], b[i][3], 1e-11 * fastest);
  }
}

TEST(ManyLoads, OneOnEachColumnPushesAsOneOnTheWholeSlab) {
  expect_same_motion(rows_after(slab(true)), rows_after(slab(false)));
}

TEST(ManyLoads, OfOneFaceAddUp) {
  Scene shared = slab(true);
  shared.loads.clear();
  for (int l = 0; l < 20; ++l) shared.loads.push_back(push_on(0, pressure / 20.0));
  expect_same_motion(rows_after(slab(true)), rows_after(shared));
}

TEST(ManyLoads, CostTheParticlesOneNumber) {
  Scene scene = slab(false);
  EXPECT_EQ(testing::start_alone(scene).particles[0].loaded_faces.components, 1);
  scene.loads.clear();
  EXPECT_EQ(testing::start_alone(scene).particles[0].loaded_faces.components, 0);
}

TEST(ManyLoads, OfOneBodyAreBitsOfADouble) {
  Scene scene = slab(true);
  scene.loads.clear();
  for (int l = 0; l < 53; ++l) scene.loads.push_back(push_on(0, 1.0));
  EXPECT_EQ(max_loaded_faces(scene), 53);
  const double all = loaded_face_bits(scene, 0, 1U << static_cast<unsigned>(Face::y_upper));
  EXPECT_EQ(all, std::ldexp(1.0, 53) - 1.0);
  EXPECT_EQ(loaded_face_bits(scene, 0, 1U << static_cast<unsigned>(Face::x_upper)), 0.0);
  scene.loads.push_back(push_on(0, 1.0));
  EXPECT_THROW(make_load_table(scene), std::logic_error);
}

TEST(ManyLoads, AreReadBackFromACheckpoint) {
  const Scene scene = slab(false);
  State state = testing::start(scene);
  const Comm& comm = *state.grid.comm;
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("barreno_many_loads_" + broadcast_from_root(comm, std::to_string(getpid())));
  if (is_root(comm)) std::filesystem::create_directories(folder);
  comm.barrier();
  testing::advance_to(scene, end, state, 5);
  for (Particles& particles : state.particles) particles.sorted = false;
  write_checkpoint(folder, "the deck", {{"rows", {3.0}}}, state);
  const BodyCensus census = take_census(scene, state.grid.comm);
  State resumed = build_empty_state(scene, census, state.grid.comm);
  const std::vector<IdRange> ids = particle_id_ranges(scene, census.first);
  read_checkpoint(scene, ids, find_checkpoint(comm, folder), resumed);
  testing::advance_to(scene, end, state);
  testing::advance_to(scene, end, resumed);
  EXPECT_EQ(testing::all_rows(state), testing::all_rows(resumed));
  comm.barrier();
  if (is_root(comm)) std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace barreno
