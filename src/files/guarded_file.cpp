// SPDX-License-Identifier: BSD-3-Clause
#include "files/guarded_file.hpp"

#include "base/error.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace barreno {

FileId id_of(int handle) {
  struct stat found {};
  if (fstat(handle, &found) != 0) return {};
  return {found.st_dev, found.st_ino};
}

FileId id_of(const std::filesystem::path& path) {
  struct stat found {};
  if (lstat(path.c_str(), &found) != 0) return {};
  return {found.st_dev, found.st_ino};
}

void remove_leftover(const std::filesystem::path& path) {
  const bool gone = unlink(path.c_str()) == 0 || errno == ENOENT || errno == ENOTDIR;
  if (!gone) refuse_file(path, "replace");
}

int create_file(const std::filesystem::path& path, const std::filesystem::path& final_name) {
  remove_leftover(path);
  constexpr mode_t mode = 0666;  // less what the user's mask forbids
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg)
  const int handle = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
  if (handle < 0) refuse_file(final_name, "write");
  return handle;
}

bool write_all(int handle, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = ::write(handle, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    done += static_cast<std::size_t>(count);
  }
  return true;
}

void refuse_if_gone(const std::filesystem::path& path, const FileId& id) {
  const FileId found = id_of(path);
  if (found == id) return;
  throw FileError(
      "cannot continue writing '" + path.string() +
      "' (it was removed, moved or replaced during the run). Leave the run folder where it is "
      "until the run has ended; start again with barreno run, or with barreno resume from where "
      "the folder is now."
  );
}

void refuse_file(const std::filesystem::path& path, const char* verb) {
  const bool link = errno == ELOOP;
  const std::string why = link         ? "it is a symbolic link, which is not followed"
                          : errno == 0 ? "the disk may be full"
                                       : std::strerror(errno);
  throw FileError(
      std::string("cannot ") + verb + " '" + path.string() + "' (" + why + "). " +
      (link ? "Remove the link" : "Free disk space") + " or choose another folder with --out."
  );
}

}  // namespace barreno
