// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "checkpoint/checkpoint_contents.hpp"
#include "checkpoint/find_checkpoint.hpp"
#include "checkpoint/hdf5_handle.hpp"
#include "checkpoint/shared_file.hpp"
#include "unit/output/synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

#include <set>

namespace barreno {
namespace {

TEST(SharedFile, IsReadByOneRankAndKnownToAll) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder(*comm);
  const auto path = folder.path() / "table.h5";
  constexpr std::size_t rows = 90000, columns = 3;  // more than one chunk
  if (is_root(*comm)) {
    Hdf5File file(path, Hdf5File::Mode::create);
    Hdf5Table<double> table{rows, columns, std::vector<double>(rows * columns)};
    for (std::size_t i = 0; i < table.values.size(); ++i) table.values[i] = 0.5 * double(i);
    file.write("group/numbers", table, "m");
    file.write("counts", Hdf5Table<long long>{2, 1, {-7, 1LL << 60}});
    file.close();
  }
  std::shared_ptr<const Hdf5File> open;
  if (is_root(*comm)) open = std::make_shared<const Hdf5File>(path, Hdf5File::Mode::read);
  const SharedFile shared(*comm, open);
  EXPECT_EQ(shared.read<long long>("counts"), (std::vector<long long>{-7, 1LL << 60}));
  std::size_t next = 0, wrong = 0;
  shared.for_each_row<double>("group/numbers", [&](std::size_t r, const double* values) {
    if (r != next++) ++wrong;
    for (std::size_t c = 0; c < columns; ++c)
      if (values[c] != 0.5 * double(r * columns + c)) ++wrong;
  });
  EXPECT_EQ(next, rows);
  EXPECT_EQ(wrong, 0U);
  EXPECT_THROW(shared.read<double>("nothing"), FileError);  // on every rank
}

TEST(CheckpointContents, NameEveryNumberOnce) {
  State state;
  std::set<std::string> names;
  int count = 0;
  for_each_number(state, [&](const char* name, auto& number) {
    names.insert(name);
    number = static_cast<std::decay_t<decltype(number)>>(++count);
  });
  EXPECT_EQ(static_cast<int>(names.size()), count);
  EXPECT_EQ(state.clock.time, 1.0);
  EXPECT_EQ(state.pore_flow.iterations, static_cast<double>(count));
  Particles particles;
  particles.material = 2;
  EXPECT_EQ(particle_group(particles), "particles/2/");
}

int closed = 0;
herr_t count_closed(hid_t) {
  ++closed;
  return 0;
}

TEST(Hdf5Handle, GivesBackWhatItGotAndNothingElse) {
  closed = 0;
  {
    const Hdf5Handle good(5, count_closed), bad(-1, count_closed);
    EXPECT_EQ(good.get(), 5);
    EXPECT_TRUE(bad.failed());
  }
  EXPECT_EQ(closed, 1);
}

TEST(FindCheckpoint, RefusesAFolderWithoutOne) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder(*comm);
  EXPECT_THROW(find_checkpoint(*comm, folder.path()), FileError);
}

TEST(DeckDifference, IsTheFirstLineThatDiffersButForTheEndTime) {
  const std::string end = "<Parameter name=\"End Time\" type=\"double\" value=\"";
  EXPECT_EQ(deck_difference("a\n" + end + "1\"/>\nb\n", "a\n" + end + "2\"/>\nb\n"), "");
  EXPECT_EQ(deck_difference("a\n  b\nc\n", "a\n  d\ne\n"), "line 2: b against d");
  EXPECT_EQ(deck_difference("a\n", "a\nb\n"), "line 2: nothing against b");
}

}  // namespace
}  // namespace barreno
