// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "exodus_reader.hpp"
#include "files/text_file.hpp"
#include "output/exodus_writer.hpp"
#include "synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

#include <barreno/models.hpp>
#include <numeric>

namespace barreno {
namespace {

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
  const ExodusReader reader(file);
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
  const ExodusReader reader(file);
  EXPECT_EQ(reader.element(1, status, 3), std::vector<double>(48, 0.0));
  EXPECT_EQ(reader.element(2, status, 3), std::vector<double>(48, 1.0));
  std::vector<double> rock(720, 1.0);
  EXPECT_EQ(reader.element(2, status, 2), rock);
  rock[removed - 1] = 0.0;
  EXPECT_EQ(reader.element(3, status, 2), rock);
}

TEST_F(ExodusWriterTest, CornersStartInTheLaunchPlaneAndStayWhereLastSeen) {
  write_run();
  const ExodusReader reader(file);
  const std::vector<double> x = reader.x();
  EXPECT_EQ(x[4 * 800], 0.0);  // a corner of the jet's first particle
  const std::vector<double> first = reader.displacement(1, 0), second = reader.displacement(2, 0),
                            third = reader.displacement(3, 0);
  EXPECT_EQ(first, std::vector<double>(x.size(), 0.0));
  const std::size_t gone = 4 * (80 + removed - 1);
  EXPECT_GT(second[gone], 0.0);
  for (std::size_t a = 0; a < 4; ++a) EXPECT_EQ(second[gone + a], third[gone + a]);
}

TEST_F(ExodusWriterTest, FollowsNoLinkAndNoticesThatItsFileIsGone) {
  const std::filesystem::path victim = folder.path() / "victim", aside = file.string() + ".tmp";
  if (comm->getRank() == 0) {
    write_whole_file(victim, "keep");
    std::filesystem::create_symlink(victim, aside);
  }
  comm->barrier();
  ExodusWriter writer(scene, synthetic::make_slots(scene), state, file, "1.2.3", {});
  writer.write(scene, state);
  comm->barrier();
  EXPECT_EQ(synthetic::read_text(victim), "keep");
  EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status(file)));
  comm->barrier();
  if (comm->getRank() == 0) std::filesystem::remove(file);
  comm->barrier();
  try {
    writer.write(scene, state);
    FAIL() << "a file that is gone was written";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("removed, moved or replaced"), std::string::npos)
        << error.what();
  }
}

TEST_F(ExodusWriterTest, WritesPointsWithARadius) {
  scene.output.glyph = Glyph::point;
  write_run();
  const ExodusReader reader(file);
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
  EXPECT_EQ(ExodusReader(file).steps(), 1);
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
  Material renamed = scene.materials[0].material();
  renamed.name = std::string(90, 'm');
  scene.materials[0] = renamed;
  const long long far = 3'000'000'000LL;
  std::vector<IdRange> slots = synthetic::make_slots(scene);
  slots.push_back({0, far, 1});
  const std::string version(80, 'v');
  ExodusWriter writer(scene, slots, state, file, version, {std::string(500, 'x')});
  writer.write(scene, state);
  writer.close(*comm);
  comm->barrier();
  const ExodusReader reader(file);
  EXPECT_EQ(reader.block_name(1), std::string(64, 'm'));
  EXPECT_EQ(reader.ids()[80], far);
}

}  // namespace
}  // namespace barreno
