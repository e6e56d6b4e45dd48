// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "files/guarded_file.hpp"
#include "files/text_file.hpp"
#include "unit/output/synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

#include <unistd.h>

namespace barreno {
namespace {

namespace fs = std::filesystem;

class GuardedFile : public ::testing::Test {
protected:
  const Teuchos::RCP<const Teuchos::Comm<int>> comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder{*comm};
  const bool root = comm->getRank() == 0;
};

TEST_F(GuardedFile, TakesThePlaceOfALinkAndNotWhatItNames) {
  if (!root) return;
  const fs::path victim = folder.path() / "victim", path = folder.path() / "history.csv";
  write_whole_file(victim, "keep me");
  fs::create_symlink(victim, path);
  const int handle = create_file(path, path);
  EXPECT_TRUE(write_all(handle, "rows"));
  EXPECT_TRUE(id_of(handle) == id_of(path));
  close(handle);
  EXPECT_EQ(synthetic::read_text(victim), "keep me");
  EXPECT_EQ(synthetic::read_text(path), "rows");
}

TEST_F(GuardedFile, IsMissedWhenItIsReplacedOrGone) {
  if (!root) return;
  const fs::path path = folder.path() / "depth.csv";
  const int handle = create_file(path, path);
  const FileId mine = id_of(handle);
  EXPECT_NO_THROW(refuse_if_gone(path, mine));
  fs::rename(path, folder.path() / "moved");
  EXPECT_THROW(refuse_if_gone(path, mine), FileError);
  write_whole_file(path, "another");
  EXPECT_THROW(refuse_if_gone(path, mine), FileError);
  close(handle);
  EXPECT_FALSE(FileId{} == FileId{});  // no file is not the same file as no file
}

TEST_F(GuardedFile, IsRefusedWhereItCannotBe) {
  if (!root) return;
  fs::create_directory(folder.path() / "taken");
  EXPECT_THROW(create_file(folder.path() / "taken", "taken"), FileError);
  EXPECT_THROW(create_file(folder.path() / "none" / "a", "none/a"), FileError);
  EXPECT_NO_THROW(remove_leftover(folder.path() / "none"));
}

}  // namespace
}  // namespace barreno
