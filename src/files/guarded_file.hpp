// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <sys/types.h>

namespace barreno {

/// Files that a run makes and keeps open: made anew, not through a symbolic link, and
/// still there whenever they are written.

/// Which file stands at a path, or is open: names may change hands, this does not.
struct FileId {
  dev_t device = 0;
  ino_t number = 0;  ///< 0: none
};
inline bool operator==(const FileId& a, const FileId& b) {
  return a.number != 0 && a.device == b.device && a.number == b.number;
}
FileId id_of(int handle);
/// Of a link the link's own.
FileId id_of(const std::filesystem::path& path);

/// Takes away what has the name of a file that is to be made: of an earlier run that was killed, or
/// laid there. A link goes, not what it names. @throws FileError if it cannot be taken away
void remove_leftover(const std::filesystem::path& path);

/// A new, empty file, open for writing; what stood there before is taken away.
/// @param final_name  that it will have, for sentences
/// @return its handle  @throws FileError
int create_file(const std::filesystem::path& path, const std::filesystem::path& final_name);

/// All bytes of a text, in as many writes as it takes. @return false, with errno, if that failed
bool write_all(int handle, const std::string& text);

/// @throws FileError unless that file stands at the path: a folder that was deleted, moved or
///         replaced during a run keeps nothing of what is still written
void refuse_if_gone(const std::filesystem::path& path, const FileId& id);

/// Throws FileError: "cannot write 'path' (why). what to do", the reason from errno.
[[noreturn]] void refuse_file(const std::filesystem::path& path, const char* verb);

}  // namespace barreno
