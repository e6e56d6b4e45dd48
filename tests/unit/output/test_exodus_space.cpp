// SPDX-License-Identifier: BSD-3-Clause
// Glyphs of three-dimensional runs: hexahedra that follow their particles, read back with the
// library's own functions.
#include "output/exodus_writer.hpp"
#include "support/scenes.hpp"
#include "synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <exodusII.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#undef TRUE
#undef FALSE

namespace barreno {
namespace {

using Point = std::array<double, 3>;

/// F and the way of every particle at the second instant.
constexpr double stretch[3][3] = {{1.5, 0.3, -0.1}, {0.2, 0.7, 0.4}, {-0.3, 0.1, 1.2}};
constexpr double way[3] = {1e-3, -2e-3, 0.5e-3};
constexpr double half[3] = {0.5e-3, 0.4e-3, 0.5e-3};

double determinant(const double (&a)[3][3]) {
  return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
         a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
         a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}

/// 4 x 3 x 1 particles of 1.0 x 0.8 x 1.0 mm.
Scene block() {
  Scene scene = testing::box_scene(
      Mode::three_dimensional, 1e-3, {0.0, 0.0, 0.0}, {0.008, 0.008, 0.008}, testing::copper()
  );
  testing::add_box(scene, "block", {0.001, 0.002, 0.003}, {0.005, 0.0044, 0.004}, 1);
  return scene;
}

void deform(State& state) {
  Particles& p = state.particles[0];
  for (int row = 0; row < p.count; ++row)
    for (int i = 0; i < 3; ++i) {
      p.position(row, i) += way[i];
      for (int k = 0; k < 3; ++k) p.deformation_gradient(row, 3 * i + k) = stretch[i][k];
    }
}

/// What a file holds: elements by their corners at both instants.
struct Elements {
  std::string topology;
  long long nodes_per_element = 0;
  std::vector<std::array<Point, 8>> before, after;
};

Elements read(const std::filesystem::path& path) {
  int computed = 8, stored = 0;
  float version = 0.0F;
  const int file = ex_open(path.c_str(), EX_READ | EX_ALL_INT64_API, &computed, &stored, &version);
  EXPECT_GE(file, 0);
  ex_init_params sizes{};
  EXPECT_EQ(ex_get_init_ext(file, &sizes), 0);
  EXPECT_EQ(sizes.num_dim, 3);
  Elements found;
  char topology[65] = "";
  int64_t count = 0, edges = 0, faces = 0, attributes = 0, nodes = 0;
  ex_get_block(file, EX_ELEM_BLOCK, 1, topology, &count, &nodes, &edges, &faces, &attributes);
  found.topology = topology;
  found.nodes_per_element = nodes;
  std::vector<int64_t> connect(static_cast<std::size_t>(count * nodes));
  ex_get_conn(file, EX_ELEM_BLOCK, 1, connect.data(), nullptr, nullptr);
  std::vector<double> start[3], moved(static_cast<std::size_t>(sizes.num_nodes));
  for (auto& values : start) values.resize(moved.size());
  ex_get_coord(file, start[0].data(), start[1].data(), start[2].data());
  found.before.resize(static_cast<std::size_t>(count));
  found.after.resize(static_cast<std::size_t>(count));
  for (std::size_t d = 0; d < 3; ++d)
    for (const int step : {1, 2}) {
      ex_get_var(file, step, EX_NODAL, static_cast<int>(d) + 1, 1, sizes.num_nodes, moved.data());
      auto& elements = step == 1 ? found.before : found.after;
      for (std::size_t e = 0; e < elements.size(); ++e)
        for (std::size_t a = 0; a < 8; ++a) {
          const auto node = static_cast<std::size_t>(connect[8 * e + a] - 1);
          elements[e][a][d] = start[d][node] + moved[node];
        }
    }
  ex_close(file);
  return found;
}

Point middle(const std::array<Point, 8>& corners) {
  Point sum{};
  for (const Point& corner : corners)
    for (std::size_t d = 0; d < 3; ++d) sum[d] += 0.125 * corner[d];
  return sum;
}

/// Volume that the edges from the first corner to those after, beside and above it span; negative
/// if the corners run the wrong way round.
double volume(const std::array<Point, 8>& corners) {
  double edges[3][3];
  for (std::size_t d = 0; d < 3; ++d) {
    edges[d][0] = corners[1][d] - corners[0][d];
    edges[d][1] = corners[3][d] - corners[0][d];
    edges[d][2] = corners[4][d] - corners[0][d];
  }
  return determinant(edges);
}

TEST(ExodusInSpace, HexahedraFollowTheDeformationGradient) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder{*comm};
  const std::filesystem::path path = folder.path() / "particles.e";
  const Scene scene = block();
  State state = testing::start(scene);
  ExodusWriter writer(
      scene,
      particle_id_ranges(scene, first_ids(scene, particle_counts(scene))),
      state,
      path,
      "1.2.3",
      {}
  );
  writer.write(scene, state);
  deform(state);
  writer.write(scene, state);
  writer.close(*comm);
  comm->barrier();

  const Elements found = read(path);
  EXPECT_EQ(found.topology, "HEX8");
  EXPECT_EQ(found.nodes_per_element, 8);
  ASSERT_EQ(found.before.size(), 12U);
  constexpr double whole = 8.0 * half[0] * half[1] * half[2];
  double total = 0.0;
  for (std::size_t e = 0; e < found.before.size(); ++e) {
    const Point from = middle(found.before[e]), to = middle(found.after[e]);
    EXPECT_NEAR(volume(found.before[e]) / whole, 1.0, 1e-12);
    EXPECT_NEAR(volume(found.after[e]) / whole, determinant(stretch), 1e-12);
    total += volume(found.before[e]);
    for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(to[d] - from[d], way[d], 1e-15);
    for (std::size_t a = 0; a < 8; ++a)
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(std::abs(found.before[e][a][i] - from[i]), half[i], 1e-15);
        double expected = to[i];
        for (std::size_t k = 0; k < 3; ++k)
          expected += stretch[i][k] * (found.before[e][a][k] - from[k]);
        EXPECT_NEAR(found.after[e][a][i], expected, 1e-15);
      }
  }
  EXPECT_NEAR(total / (0.004 * 0.0024 * 0.001), 1.0, 1e-12);
}

}  // namespace
}  // namespace barreno
