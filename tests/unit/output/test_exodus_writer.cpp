// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "output/exodus_writer.hpp"
#include "synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <exodusII.h>
#include <gtest/gtest.h>
#undef TRUE
#undef FALSE

#include <numeric>

namespace barreno {
namespace {

/// Reads back with the library's own functions.
class Reader {
public:
  explicit Reader(const std::filesystem::path& path) {
    int computed = 8, stored = 0;
    float version = 0.0F;
    file_ = ex_open(path.c_str(), EX_READ | EX_ALL_INT64_API, &computed, &stored, &version);
    EXPECT_GE(file_, 0);
    EXPECT_EQ(stored, 8);
    ex_set_max_name_length(file_, 64);
    EXPECT_EQ(ex_get_init_ext(file_, &sizes), 0);
  }
  ~Reader() { ex_close(file_); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  std::string block_name(int block) const {
    char name[65] = "";
    ex_get_name(file_, EX_ELEM_BLOCK, block, name);
    return name;
  }
  long long block_size(int block) const {
    char topology[65] = "";
    int64_t elements = 0, nodes = 0, edges = 0, faces = 0, attributes = 0;
    ex_get_block(
        file_, EX_ELEM_BLOCK, block, topology, &elements, &nodes, &edges, &faces, &attributes
    );
    return elements;
  }
  std::vector<int64_t> ids() const {
    std::vector<int64_t> ids(static_cast<std::size_t>(sizes.num_elem));
    ex_get_id_map(file_, EX_ELEM_MAP, ids.data());
    return ids;
  }
  std::vector<double> x() const {
    std::vector<double> x(static_cast<std::size_t>(sizes.num_nodes)), y = x;
    ex_get_coord(file_, x.data(), y.data(), nullptr);
    return x;
  }
  std::vector<double> element(int step, int variable, int block) const {
    std::vector<double> values(static_cast<std::size_t>(block_size(block)));
    const auto count = static_cast<int64_t>(values.size());
    ex_get_var(file_, step, EX_ELEM_BLOCK, variable, block, count, values.data());
    return values;
  }
  std::vector<double> displacement(int step, int direction) const {
    std::vector<double> values(static_cast<std::size_t>(sizes.num_nodes));
    ex_get_var(file_, step, EX_NODAL, direction + 1, 1, sizes.num_nodes, values.data());
    return values;
  }
  int steps() const { return static_cast<int>(ex_inquire_int(file_, EX_INQ_TIME)); }

  ex_init_params sizes{};

private:
  int file_ = -1;
};

class ExodusWriterTest : public ::testing::Test {
protected:
  void write_run() {
    ExodusWriter writer(scene, synthetic::make_slots(scene), state, file, "1.2.3", {"a deck line"});
    writer.write(scene, state);
    synthetic::move_to(scene, state, 5.5e-6);  // all slugs are launched
    writer.write(scene, state);
    synthetic::remove_particle(state, removed);
    synthetic::move_to(scene, state, 6e-6);
    writer.write(scene, state);
    writer.close(*comm);
    comm->barrier();
  }
  const Teuchos::RCP<const Comm> comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder{*comm};
  const std::filesystem::path file = folder.path() / "particles.e";
  Scene scene = synthetic::make_scene();
  State state = synthetic::make_state(scene, comm);
  static constexpr ParticleId removed = 3;  // in the rock, which is block 2
  static constexpr int status = 1;          // the first variable
};

TEST_F(ExodusWriterTest, KeepsAPlaceForEveryParticleSortedById) {
  write_run();
  const Reader reader(file);
  EXPECT_EQ(reader.sizes.num_elem_blk, 3);
  EXPECT_EQ(reader.block_name(1), "steel");
  EXPECT_EQ(reader.block_name(2), "sandstone");
  EXPECT_EQ(reader.block_size(1), 80);
  EXPECT_EQ(reader.block_size(2), 720);
  EXPECT_EQ(reader.block_size(3), 48);
  std::vector<int64_t> expected(848);
  std::iota(expected.begin(), expected.begin() + 80, 721);  // the rock comes first in the scene
  std::iota(expected.begin() + 80, expected.begin() + 800, 1);
  std::iota(expected.begin() + 800, expected.end(), 801);
  EXPECT_EQ(reader.ids(), expected);
  EXPECT_EQ(reader.steps(), 3);
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".tmp"));
}

TEST_F(ExodusWriterTest, StatusSaysWhoExists) {
  write_run();
  const Reader reader(file);
  EXPECT_EQ(reader.element(1, status, 3), std::vector<double>(48, 0.0));
  EXPECT_EQ(reader.element(2, status, 3), std::vector<double>(48, 1.0));
  std::vector<double> rock(720, 1.0);
  EXPECT_EQ(reader.element(2, status, 2), rock);
  rock[removed - 1] = 0.0;
  EXPECT_EQ(reader.element(3, status, 2), rock);
}

TEST_F(ExodusWriterTest, CornersStartInTheLaunchPlaneAndStayWhereLastSeen) {
  write_run();
  const Reader reader(file);
  const std::vector<double> x = reader.x();
  EXPECT_EQ(x[4 * 800], 0.0);  // a corner of the jet's first particle
  const std::vector<double> first = reader.displacement(1, 0), second = reader.displacement(2, 0),
                            third = reader.displacement(3, 0);
  EXPECT_EQ(first, std::vector<double>(x.size(), 0.0));
  const std::size_t gone = 4 * (80 + removed - 1);
  EXPECT_GT(second[gone], 0.0);
  for (std::size_t a = 0; a < 4; ++a) EXPECT_EQ(second[gone + a], third[gone + a]);
}

TEST_F(ExodusWriterTest, WritesPointsWithARadius) {
  scene.output.glyph = Glyph::point;
  write_run();
  const Reader reader(file);
  EXPECT_EQ(reader.sizes.num_nodes, 848);
}

TEST_F(ExodusWriterTest, WritesASceneWithoutParticles) {
  scene.bodies.clear();
  scene.jet.slugs.clear();
  state = synthetic::make_state(scene, comm);
  ExodusWriter writer(scene, {}, state, file, "1.2.3", {});
  writer.write(scene, state);
  writer.close(*comm);
  comm->barrier();
  EXPECT_EQ(Reader(file).steps(), 1);
}

TEST_F(ExodusWriterTest, FailsOnEveryRankAndLeavesNothing) {
  const auto bad = folder.path() / "none" / "particles.e";
  EXPECT_THROW(ExodusWriter(scene, synthetic::make_slots(scene), state, bad, "1", {}), FileError);
  { const ExodusWriter unused(scene, synthetic::make_slots(scene), state, file, "1", {}); }
  comm->barrier();
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(ExodusWriterTest, AcceptsLongTextsAndIds) {
  scene.title = std::string(300, 't');
  scene.materials[0].material.name = std::string(90, 'm');
  const long long far = 3'000'000'000LL;
  std::vector<SlotRange> slots = synthetic::make_slots(scene);
  slots.push_back({0, far, 1});
  const std::string version(80, 'v');
  ExodusWriter writer(scene, slots, state, file, version, {std::string(500, 'x')});
  writer.write(scene, state);
  writer.close(*comm);
  comm->barrier();
  const Reader reader(file);
  EXPECT_EQ(reader.block_name(1), std::string(64, 'm'));
  EXPECT_EQ(reader.ids()[80], far);
}

}  // namespace
}  // namespace barreno
