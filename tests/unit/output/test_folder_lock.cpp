// SPDX-License-Identifier: BSD-3-Clause
// A run folder belongs to one run at a time, and to the next when the last rank has gone.
#include "base/error.hpp"
#include "files/text_file.hpp"
#include "output/folder_lock.hpp"
#include "synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>
#include <Teuchos_DefaultSerialComm.hpp>

#include <gtest/gtest.h>

#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace barreno {
namespace {

namespace fs = std::filesystem;

/// Another run on one rank.
std::string refusal(const fs::path& folder, double wait_seconds = 0.0) {
  const Teuchos::SerialComm<int> alone;
  try {
    const FolderLock lock(alone, folder, wait_seconds);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

TEST(FolderLock, KeepsOthersOutAndNamesItsHolder) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder(*comm);
  {
    const FolderLock lock(*comm, folder.path());
    const std::string said = refusal(folder.path());
    EXPECT_NE(said.find("is in use (process "), std::string::npos) << said;
    EXPECT_NE(said.find(" on "), std::string::npos) << said;
    EXPECT_NE(said.find("; wait until that process ends, or stop it."), std::string::npos) << said;
    comm->barrier();
  }
  comm->barrier();
  EXPECT_FALSE(fs::exists(folder.path() / folder_lock_name));
  comm->barrier();
  if (is_root(*comm)) {
    EXPECT_EQ(refusal(folder.path()), "");
  }
}

TEST(FolderLock, LastsUntilTheLastRankHasGone) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder(*comm);
  if (!is_root(*comm)) return;
  // Rank 0 of a killed run has gone, another one still shares byte 1.
  const fs::path path = folder.path() / folder_lock_name;
  const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  struct flock shared {};
  shared.l_type = F_RDLCK;
  shared.l_start = 1;
  shared.l_len = 1;
  ASSERT_EQ(fcntl(file, F_OFD_SETLK, &shared), 0);
  EXPECT_NE(refusal(folder.path()).find("is in use"), std::string::npos);
  close(file);
  EXPECT_EQ(refusal(folder.path()), "");
}

/// A process that locks the folder and is killed.
class Victim {
public:
  explicit Victim(const fs::path& folder) : id_(fork()) {
    if (id_ != 0) return;
    const Teuchos::SerialComm<int> alone;
    const FolderLock lock(alone, folder);
    pause();
    _exit(0);
  }
  void kill_it() {
    kill(id_, SIGKILL);
    waitpid(id_, nullptr, 0);
  }

private:
  pid_t id_;
};

TEST(FolderLock, OfAKilledRunLocksNothing) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder(*comm);
  if (is_root(*comm)) {
    Victim victim(folder.path());
    for (int look = 0; look < 100 && !fs::exists(folder.path() / folder_lock_name); ++look)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_NE(refusal(folder.path()), "");
    victim.kill_it();
    EXPECT_TRUE(fs::exists(folder.path() / folder_lock_name));
    EXPECT_EQ(refusal(folder.path()), "");
  }
}

TEST(FolderLock, IsWaitedFor) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder(*comm);
  if (is_root(*comm)) {
    Victim victim(folder.path());
    for (int look = 0; look < 100 && refusal(folder.path()).empty(); ++look)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::thread later([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
      victim.kill_it();
    });
    EXPECT_EQ(refusal(folder.path(), 10.0), "");
    later.join();
  }
}

TEST(FolderLock, FollowsNoLinkAndWaitsForNoPipe) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder(*comm);
  const fs::path other = folder.path() / "other", lock = folder.path() / folder_lock_name;
  if (is_root(*comm)) {
    write_whole_file(other, "the user's own");
    fs::create_symlink(other, lock);
    EXPECT_NE(refusal(folder.path()).find("run.lock is a link"), std::string::npos);
    EXPECT_EQ(synthetic::read_text(other), "the user's own");
    fs::remove(lock);
    fs::create_directory(lock);
    EXPECT_NE(refusal(folder.path()), "");
  }
}

}  // namespace
}  // namespace barreno
