// SPDX-License-Identifier: BSD-3-Clause
#include "output/folder_lock.hpp"

#include "base/error.hpp"
#include "files/guarded_file.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <iostream>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace barreno {
namespace {

namespace fs = std::filesystem;

constexpr off_t own_byte = 0;     ///< rank 0's alone
constexpr off_t shared_byte = 1;  ///< of all ranks
constexpr auto between_looks = std::chrono::milliseconds(50);

/// @param kind  F_WRLCK or F_RDLCK
/// @return 0 or the system's error
int lock_bytes(int file, short kind, off_t first, off_t count) {
  struct flock lock {};
  lock.l_type = kind;
  lock.l_whence = SEEK_SET;
  lock.l_start = first;
  lock.l_len = count;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg)
  return fcntl(file, F_OFD_SETLK, &lock) == 0 ? 0 : errno;
}

bool is_held(int error) {
  return error == EAGAIN || error == EACCES;
}

/// Disks without locks say one of these.
bool has_no_locks(int error) {
  return error == ENOLCK || error == EOPNOTSUPP || error == ENOSYS || error == EINVAL;
}

[[noreturn]] void refuse_lock(const fs::path& path, const std::string& why) {
  throw FileError(
      "cannot write into the run folder '" + path.parent_path().string() + "' (" + why +
      "). Give another one with --out."
  );
}

/// A link is not followed, and a pipe is not waited for.
int open_lock(const fs::path& path) {
  constexpr int flags = O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg)
  const int file = open(path.c_str(), flags, 0666);
  const std::string name = path.filename().string();
  if (file < 0 && errno == ELOOP) refuse_lock(path, name + " is a link");
  if (file < 0) refuse_lock(path, std::string(std::strerror(errno)) + ": " + name);
  struct stat found {};
  if (fstat(file, &found) == 0 && S_ISREG(found.st_mode)) return file;
  close(file);
  refuse_lock(path, name + " is not a regular file");
}

/// Whether the name still belongs to the open file: the run before may have removed it meanwhile.
bool has_name(int file, const fs::path& path) {
  return id_of(file) == id_of(path);
}

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "an unknown host";
}

std::string holder_text() {
  const std::time_t now = std::time(nullptr);
  std::array<char, 32> time{};
  std::tm parts{};
  std::strftime(time.data(), time.size(), "%Y-%m-%d %H:%M:%S UTC", gmtime_r(&now, &parts));
  return "process " + std::to_string(getpid()) + " on " + host_name() + ", since " + time.data();
}

/// What the holder wrote about itself.
std::string holder_of(int file) {
  std::array<char, 512> text{};
  const ssize_t bytes = pread(file, text.data(), text.size() - 1, 0);
  std::string holder(text.data(), static_cast<std::size_t>(std::max<ssize_t>(bytes, 0)));
  holder = holder.substr(0, holder.find('\n'));
  return holder.empty() ? "another process" : holder;
}

void write_holder(int file, const fs::path& path) {
  const std::string text = holder_text() + "\n";
  const bool fine = ftruncate(file, 0) == 0 &&
                    pwrite(file, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
  if (!fine) refuse_lock(path, std::strerror(errno));
}

/// One attempt. @return whether it has the lock; `holder` says who has it otherwise
bool try_lock(const fs::path& path, int& file, std::string& holder) {
  file = open_lock(path);
  const int error = lock_bytes(file, F_WRLCK, own_byte, 2);
  if (error == 0 && has_name(file, path)) return true;
  if (has_no_locks(error)) {
    std::cerr << "barreno: note: the disk of '" << path.parent_path().string()
              << "' has no file locks (" << std::strerror(error)
              << "): make sure that no other run uses this folder." << std::endl;
    return true;
  }
  if (is_held(error)) holder = holder_of(file);
  close(file);
  file = -1;
  if (error != 0 && !is_held(error)) refuse_lock(path, std::strerror(error));
  return false;
}

/// Rank 0's part.
int wait_for_lock(const fs::path& path, double wait_seconds) {
  using Watch = std::chrono::steady_clock;
  const auto end = Watch::now() + std::chrono::duration<double>(wait_seconds);
  const std::string in_use = "the run folder '" + path.parent_path().string() + "' is in use (";
  std::string holder;
  int file = -1;
  for (bool told = false; !try_lock(path, file, holder); told = true) {
    if (Watch::now() >= end)
      throw FileError(
          std::string(in_use).append(holder).append("); wait until that process ends, or stop it.")
      );
    if (!told && !holder.empty())
      std::cerr << "barreno: " << in_use << holder << "); waiting up to " << wait_seconds
                << " s for that process to end." << std::endl;
    std::this_thread::sleep_for(between_looks);
  }
  write_holder(file, path);
  lock_bytes(file, F_RDLCK, shared_byte, 1);  // now the other ranks may share it
  return file;
}

/// Another rank's part. Where it does not see the folder, it cannot write into it either.
int share_lock(const fs::path& path) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg)
  const int file = open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file >= 0) lock_bytes(file, F_RDLCK, shared_byte, 1);
  return file;
}

}  // namespace

FolderLock::FolderLock(const Comm& comm, const fs::path& folder, double wait_seconds)
    : path_((folder.empty() ? fs::path(".") : folder) / folder_lock_name), root_(is_root(comm)) {
  RootWork work(comm);
  work.run([&] { file_ = wait_for_lock(path_, wait_seconds); });
  work.agree();
  if (!root_) file_ = share_lock(path_);
  comm.barrier();
}

FolderLock::~FolderLock() {
  if (file_ < 0) return;
  if (root_ && has_name(file_, path_)) unlink(path_.c_str());
  close(file_);
}

}  // namespace barreno
