// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "files/text_file.hpp"
#include "output/run_folder.hpp"
#include "synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

namespace barreno {
namespace {

namespace fs = std::filesystem;

std::string refusal(const Comm& comm, const RunFolderRequest& request) {
  try {
    create_run_folder(comm, request);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

TEST(RunFolder, IsCreatedWithItsParents) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder here(*comm);
  const fs::path wanted = here.path() / "a" / "b";
  EXPECT_EQ(create_run_folder(*comm, {wanted.string(), false, "deck"}), wanted);
  EXPECT_TRUE(fs::is_empty(wanted));
  comm->barrier();
  EXPECT_EQ(refusal(*comm, {wanted.string(), false, "deck"}), "");  // an empty one may be used
  comm->barrier();
}

TEST(RunFolder, WithAResultIsRefusedUnlessOverwritten) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder here(*comm);
  const std::string out = here.path().string();
  if (comm->getRank() == 0) {
    write_whole_file(here.path() / "history.csv", "old");
    write_whole_file(here.path() / "notes.txt", "the user's own");
  }
  comm->barrier();
  EXPECT_EQ(
      refusal(*comm, {out, false, "deck"}),
      "the run folder '" + out +
          "' already holds a result (history.csv). Give another one with --out, or add --overwrite."
  );
  EXPECT_TRUE(fs::exists(here.path() / "history.csv"));
  comm->barrier();
  EXPECT_EQ(refusal(*comm, {out, true, "deck"}), "");
  EXPECT_TRUE(fs::exists(here.path() / "history.csv"));  // until the folder is locked
  comm->barrier();
  EXPECT_THROW(clear_run_folder(*comm, out, false), FileError);
  EXPECT_TRUE(fs::exists(here.path() / "history.csv"));
  comm->barrier();
  clear_run_folder(*comm, out, true);
  comm->barrier();
  EXPECT_FALSE(fs::exists(here.path() / "history.csv"));
  EXPECT_TRUE(fs::exists(here.path() / "notes.txt"));
}

TEST(RunFolder, ThatCannotBeMadeIsOneSentence) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder here(*comm);
  const std::string file = (here.path() / "file").string();
  if (comm->getRank() == 0) write_whole_file(file, "x");
  comm->barrier();
  EXPECT_EQ(
      refusal(*comm, {file, false, "deck"}),
      "cannot write into the run folder '" + file + "' (it is a file). Give another one with --out."
  );
  EXPECT_NE(refusal(*comm, {file + "/below", false, "deck"}), "");
  EXPECT_NE(refusal(*comm, {"/proc/none", false, "deck"}), "");
}

TEST(RunFolder, IsNewEveryTimeWithoutAName) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder here(*comm);
  const fs::path back = fs::current_path();
  fs::current_path(here.path());
  EXPECT_EQ(create_run_folder(*comm, {"", false, "deck"}), fs::path("runs") / "deck-1");
  EXPECT_EQ(create_run_folder(*comm, {"", false, "deck"}), fs::path("runs") / "deck-2");
  fs::current_path(back);
}

}  // namespace
}  // namespace barreno
