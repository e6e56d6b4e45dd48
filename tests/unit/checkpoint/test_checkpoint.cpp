// SPDX-License-Identifier: BSD-3-Clause
// A checkpoint is the state to the bit, and a damaged one is never taken for whole.
#include "base/error.hpp"
#include "checkpoint/hdf5_file.hpp"
#include "checkpoint/read_checkpoint.hpp"
#include "checkpoint/seal.hpp"
#include "checkpoint/write_checkpoint.hpp"
#include "state/balance.hpp"
#include "state/build_state.hpp"
#include "support/scenes.hpp"
#include "unit/output/synthetic_run.hpp"

#include <Teuchos_DefaultSerialComm.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <fstream>
#include <iterator>

namespace barreno {
namespace {

namespace fs = std::filesystem;

/// Two copper blocks that meet.
Scene impact() {
  Scene scene = testing::box_scene(
      Mode::plane_strain, 1e-3, {0.0, 0.0, 0.0}, {0.012, 0.012, 0.0}, testing::copper()
  );
  testing::add_box(scene, "flyer", {0.003, 0.002, 0.0}, {0.008, 0.0048, 0.0}, 2).velocity = {
      0.0, 400.0, 0.0};
  testing::add_box(scene, "block", {0.002, 0.005, 0.0}, {0.01, 0.009, 0.0}, 2);
  scene.end_time = 1e-5;
  return scene;
}

/// What a checkpoint keeps of all ranks together, in whole numbers where it is a sum.
std::vector<double> sums_of(const State& state) {
  const Comm& comm = *state.grid.comm;
  std::vector<ReproducibleSum> terms = terms_of(state.ledger);
  for (const ReproducibleSum& term : material_terms_of(state.ledger)) terms.push_back(term);
  sum_over_ranks(comm, terms);
  std::vector<double> steps{state.particle_steps, state.skipped_steps};
  sum_over_ranks(comm, steps);
  // A rank's own until the next step takes the least of all.
  std::vector<double> stable{state.stable_step};
  for (const Particles& particles : state.particles) stable.push_back(particles.stable_step);
  min_over_ranks(comm, stable);
  std::vector<double> numbers{steps[0], steps[1]};
  numbers.insert(numbers.end(), stable.begin(), stable.end());
  const std::vector<double> limits = values_of(state.step_limits);
  numbers.insert(numbers.end(), limits.begin(), limits.end());
  for (ReproducibleSum& term : terms) {
    term.carry();
    for (const long long part : term.part) numbers.push_back(static_cast<double>(part));
  }
  return numbers;
}

/// Every number of this rank that a checkpoint keeps, as bytes: -0 is not 0 here.
std::vector<unsigned char> bytes_of(const State& state) {
  std::vector<double> numbers = sums_of(state);
  for (const Particles& particles : state.particles) {
    numbers.push_back(particles.count);
    for (int p = 0; p < particles.count; ++p) {
      numbers.push_back(static_cast<double>(particles.id(p)));
      numbers.push_back(particles.body(p));
    }
    particles.for_each_field([&](const Field& field) {
      for (int p = 0; p < particles.count; ++p)
        for (int c = 0; c < field.components; ++c) numbers.push_back(field(p, c));
    });
  }
  for_each_number(state, [&](const char*, const auto& value) {
    numbers.push_back(static_cast<double>(value));
  });
  for (const int owner : state.grid.owner) numbers.push_back(owner);
  std::vector<unsigned char> bytes(numbers.size() * sizeof(double));
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

std::vector<char> read_bytes(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write_bytes(const fs::path& file, const std::vector<char>& bytes, std::size_t count) {
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(count));
}

class CheckpointTest : public ::testing::Test {
protected:
  void write(const std::string& deck) {
    write_checkpoint(folder.path(), deck, {{"rows", {3.0, 0.1}}}, state);
    comm.barrier();
  }
  void go_on(long steps) { testing::advance_to(scene, scene.end_time, state, steps); }
  /// What a run that begins with the checkpoint has.
  State read(const Checkpoint& checkpoint) const {
    const BodyCensus census = take_census(scene, state.grid.comm);
    State other = build_empty_state(scene, census, state.grid.comm);
    read_checkpoint(scene, particle_id_ranges(scene, census.first), checkpoint, other);
    return other;
  }
  const Scene scene = impact();
  State state = testing::start(scene);
  const Comm& comm = *state.grid.comm;
  const synthetic::TemporaryFolder folder{comm};
  const fs::path file = folder.path() / checkpoint_name;
};

TEST_F(CheckpointTest, IsTheStateToTheBit) {
  go_on(7);
  write("the deck\n");
  const Checkpoint found = find_checkpoint(comm, folder.path());
  EXPECT_EQ(found.file, file);
  EXPECT_EQ(found.deck_text, "the deck\n");
  EXPECT_EQ(found.output.at("rows"), (std::vector<double>{3.0, 0.1}));
  EXPECT_TRUE(found.notes.empty());
  State other = read(found);
  EXPECT_EQ(other.clock.step, 7);
  EXPECT_EQ(bytes_of(other), bytes_of(state));
  // And it goes on as the state that it was taken from.
  for (State* one : {&state, &other}) {
    for (Particles& particles : one->particles) particles.sorted = false;
    testing::advance_to(scene, scene.end_time, *one, 5);
  }
  EXPECT_EQ(bytes_of(other), bytes_of(state));
}

TEST_F(CheckpointTest, KeepsTheOneBefore) {
  go_on(3);
  const std::vector<unsigned char> before = bytes_of(state);
  write("first");
  go_on(3);
  write("second");
  EXPECT_EQ(find_checkpoint(comm, folder.path()).deck_text, "second");
  EXPECT_EQ(bytes_of(read(find_checkpoint(comm, folder.path()))), bytes_of(state));
  if (is_root(comm)) fs::resize_file(file, fs::file_size(file) / 2);
  comm.barrier();
  const Checkpoint found = find_checkpoint(comm, folder.path());
  EXPECT_EQ(found.deck_text, "first");
  EXPECT_EQ(found.file.filename(), previous_checkpoint_name);
  EXPECT_EQ(bytes_of(read(found)), before);
  if (is_root(comm)) {
    ASSERT_EQ(found.notes.size(), 1U);
    EXPECT_NE(found.notes[0].find("skipped"), std::string::npos);
  }
}

TEST_F(CheckpointTest, FindsEveryWrongBitAndEveryCut) {
  write("the deck");
  const std::vector<char> whole = read_bytes(file);
  comm.barrier();
  const auto expect_refused = [&](const std::string& what) {
    comm.barrier();
    EXPECT_THROW(find_checkpoint(comm, folder.path()), FileError) << what;
    comm.barrier();
  };
  const std::size_t stride = whole.size() / 50;
  for (std::size_t at = 3; at < whole.size(); at += stride) {
    std::vector<char> wrong = whole;
    wrong[at] = static_cast<char>(wrong[at] ^ (1 << at % 8));
    if (is_root(comm)) write_bytes(file, wrong, wrong.size());
    expect_refused("a bit of byte " + std::to_string(at));
    if (is_root(comm)) write_bytes(file, whole, at);
    expect_refused(std::to_string(at) + " bytes left");
  }
  if (is_root(comm)) write_bytes(file, whole, whole.size());
  comm.barrier();
  EXPECT_EQ(find_checkpoint(comm, folder.path()).deck_text, "the deck");
}

TEST_F(CheckpointTest, RefusesAnotherVersionAndAnEmptyFolder) {
  EXPECT_THROW(find_checkpoint(comm, folder.path()), FileError);
  if (is_root(comm)) {
    Hdf5File other(file, Hdf5File::Mode::create);
    other.write("run/version", {1, 1, {checkpoint_version + 1.0}}, "");
    other.close();
    seal_checkpoint(file);
    EXPECT_EQ(SealedFile(Teuchos::SerialComm<int>(), file).fault(), "");
  }
  comm.barrier();
  try {
    find_checkpoint(comm, folder.path());
    FAIL() << "no error";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("version"), std::string::npos);
  }
}

TEST_F(CheckpointTest, AFolderThatIsGoneIsAnErrorOnEveryRankAndCostsNothing) {
  write("first");
  EXPECT_THROW(write_checkpoint(folder.path() / "none", "x", {}, state), FileError);
  // The next one cannot be written beside a folder of its name; the first one stays.
  const fs::path aside = file.string() + ".tmp";
  if (is_root(comm)) fs::create_directory(aside);
  comm.barrier();
  EXPECT_THROW(write_checkpoint(folder.path(), "second", {}, state), FileError);
  comm.barrier();
  EXPECT_EQ(find_checkpoint(comm, folder.path()).deck_text, "first");
}

TEST_F(CheckpointTest, FollowsNoLinkOfTheNameItIsWrittenUnder) {
  const fs::path victim = folder.path() / "victim", aside = file.string() + ".tmp";
  if (is_root(comm)) {
    std::ofstream(victim) << "keep";
    fs::create_symlink(victim, aside);
  }
  comm.barrier();
  write("the deck\n");
  EXPECT_EQ(synthetic::read_text(victim), "keep");
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(file)));
  EXPECT_EQ(find_checkpoint(comm, folder.path()).deck_text, "the deck\n");
}

TEST(DeckDifference, NamesTheFirstLineButNotTheEndTime) {
  const std::string deck = "a\n  name=\"End Time\" value=\"1\"\n  b\n";
  EXPECT_EQ(deck_difference(deck, deck), "");
  const std::string longest = "a\n  name=\"End Time\" value=\"at rest\"\n  name=\"Longest Time\"\n";
  EXPECT_EQ(deck_difference(deck, longest + "  b\n"), "");
  EXPECT_EQ(deck_difference(longest + "  b\n", deck), "");
  EXPECT_NE(deck_difference(deck, longest + "  c\n"), "");
  EXPECT_EQ(deck_difference(deck, "a\n  name=\"End Time\" value=\"2\"\n  b\n"), "");
  EXPECT_EQ(
      deck_difference(deck, "a\n  name=\"End Time\" value=\"1\"\n  c\n"), "line 3: b against c"
  );
  EXPECT_EQ(deck_difference("a\n", "a\nb\n"), "line 2: nothing against b");
  EXPECT_EQ(deck_difference("a\nb", "a\nb\n"), "the last line has no end");
}

}  // namespace
}  // namespace barreno
