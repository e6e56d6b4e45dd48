// SPDX-License-Identifier: BSD-3-Clause
// A set of files holds what one file would, on any number of ranks.
#include "base/error.hpp"
#include "exodus_reader.hpp"
#include "output/exodus_writer.hpp"
#include "synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <map>

namespace barreno {
namespace {

constexpr int variables = 12, blocks = 3, steps = 3;

/// By block, variable and step, the values of a particle; displacements of its corners as well.
using Values = std::map<int64_t, std::vector<double>>;

void read_into(const std::filesystem::path& file, Values& values) {
  const ExodusReader reader(file);
  const std::vector<int64_t> ids = reader.ids();
  const auto corners = ids.empty() ? 0 : reader.sizes.num_nodes / reader.sizes.num_elem;
  for (const int64_t id : ids) EXPECT_EQ(values.count(id), 0U) << id << " is in two files";
  for (int step = 1; step <= reader.steps(); ++step) {
    for (int variable = 1; variable <= variables; ++variable) {
      std::size_t e = 0;
      for (int block = 1; block <= blocks; ++block)
        for (const double value : reader.element(step, variable, block))
          values[ids[e++]].push_back(value);
    }
    for (const int direction : {0, 1}) {
      if (ids.empty()) continue;
      const std::vector<double> moved = reader.displacement(step, direction);
      for (std::size_t n = 0; n < moved.size(); ++n)
        values[ids[n / static_cast<std::size_t>(corners)]].push_back(moved[n]);
    }
  }
}

class FileSetTest : public ::testing::Test {
protected:
  ExodusWriter writer(const std::filesystem::path& path, const KeptFields& kept) const {
    return {scene, synthetic::make_slots(scene), start, path, "1.2.3", {"a deck line"}, kept};
  }
  /// The steps from `first` on.
  void write_steps(const std::filesystem::path& path, const KeptFields& kept) {
    ExodusWriter files = writer(path, kept);
    State state = synthetic::make_state(scene, comm);
    for (int step = 0; step < steps; ++step) {
      if (step == 2) synthetic::remove_particle(state, 3);
      synthetic::move_to(scene, state, 3e-6 * step);
      if (step >= kept.steps) files.write(scene, state);
    }
    EXPECT_EQ(files.steps(), steps);
    files.close(*comm);
    comm->barrier();
  }
  Values read_set(const std::filesystem::path& path, int files) const {
    Values values;
    const FileShares shares = divide_among_files(synthetic::make_slots(scene), blocks, files);
    for (int file = 0; file < files; ++file) read_into(name_in_set(path, shares, file), values);
    return values;
  }
  Values read_one() {
    scene.output.files = ParticleFiles::one;
    write_steps(folder.path() / "one.e", {});
    scene.output.files = ParticleFiles::one_per_rank;
    return read_set(folder.path() / "one.e", 1);
  }
  const Teuchos::RCP<const Comm> comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder{*comm};
  const std::filesystem::path set = folder.path() / "particles.e";
  Scene scene = synthetic::make_scene();
  const State start = synthetic::make_state(scene, comm);
};

TEST_F(FileSetTest, HoldsWhatOneFileHolds) {
  const Values one = read_one();
  EXPECT_EQ(one.size(), 848U);
  write_steps(set, {});
  EXPECT_EQ(read_set(set, comm->getSize()), one);
  // More files than ranks, and than particles of the jet.
  for (const int files : {5, 50}) {
    write_steps(set, {0, files});
    EXPECT_EQ(read_set(set, files), one) << files << " files";
  }
}

TEST_F(FileSetTest, SaysWhatItIsPartOf) {
  scene.output.files = ParticleFiles::one_per_rank;
  write_steps(set, {0, 50});
  int64_t elements = 0;
  for (const char* number : {"00", "07", "49"}) {
    const ExodusReader reader(set.string() + ".50." + number);
    EXPECT_EQ(reader.set(), (std::vector<int64_t>{50, 1, 4 * 848, 848, 3, 80, 720, 48}));
    EXPECT_EQ(reader.globals(1, 3)[2], 808.0);  // of all files, with the first slug
    EXPECT_EQ(reader.sizes.num_elem_blk, 3);
    elements += reader.sizes.num_elem;
  }
  EXPECT_NEAR(static_cast<double>(elements), 3 * 848 / 50.0, 5.0);
}

TEST_F(FileSetTest, FilesWithoutParticlesAreWhole) {
  scene.output.files = ParticleFiles::one_per_rank;
  scene.bodies.clear();
  scene.jet.slugs.resize(1);  // eight particles
  const State state = synthetic::make_state(scene, comm);
  ExodusWriter files(
      scene, synthetic::make_slots(scene), state, set, "1.2.3", {}, KeptFields{0, 20}
  );
  files.write(scene, state);
  files.close(*comm);
  comm->barrier();
  int empty = 0;
  for (int file = 10; file < 20; ++file) {
    const ExodusReader reader(set.string() + ".20." + std::to_string(file));
    EXPECT_EQ(reader.steps(), 1);
    EXPECT_EQ(reader.set(), (std::vector<int64_t>{20, 1, 32, 8, 3, 0, 0, 8}));
    empty += reader.sizes.num_elem == 0 ? 1 : 0;
  }
  EXPECT_EQ(empty, 6);
}

TEST_F(FileSetTest, GoesOnFromItsFirstSteps) {
  const Values one = read_one();
  for (const int kept : {1, 2}) {
    write_steps(set, {0, 5});
    write_steps(set, {kept, 5});
    EXPECT_EQ(read_set(set, 5), one) << kept << " steps kept";
  }
}

TEST_F(FileSetTest, SaysWhatOneRankCannotWrite) {
  const std::vector<IdRange> many{{1, 1, 5'000'000'000LL}};
  try {
    const ExodusWriter none(scene, many, start, set, "1.2.3", {});
    FAIL() << "no error";
  } catch (const DeckError& error) {
    EXPECT_NE(
        std::string(error.what()).find("5000000000 particles of 'sandstone'"), std::string::npos
    );
  }
}

TEST_F(FileSetTest, TouchesNoFileWhereOneIsMissing) {
  scene.output.files = ParticleFiles::one_per_rank;
  write_steps(set, {0, 5});
  if (is_root(*comm)) std::filesystem::remove(set.string() + ".5.4");
  comm->barrier();
  try {
    writer(set, {1, 5});
    FAIL() << "no error";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("particles.e.5.4'"), std::string::npos);
  }
  comm->barrier();
  for (const char* number : {"0", "1", "2", "3"})
    EXPECT_EQ(ExodusReader(set.string() + ".5." + number).steps(), steps);
}

TEST_F(FileSetTest, OneFileThatCannotBeWrittenIsAnErrorOnEveryRank) {
  scene.output.files = ParticleFiles::one_per_rank;
  const std::string blocked = set.string() + ".5.3";
  if (is_root(*comm)) std::filesystem::create_directory(blocked + ".tmp");
  comm->barrier();
  try {
    writer(set, {0, 5});
    FAIL() << "no error";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find(blocked), std::string::npos);
  }
  comm->barrier();
  EXPECT_EQ(
      std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1
  );  // that folder alone
}

}  // namespace
}  // namespace barreno
