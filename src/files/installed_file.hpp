// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace barreno {

/// Where a file may be that is installed with the program: below the prefix, which may be moved as
/// a whole, in the source tree, and where it was installed first.
struct InstalledFolders {
  const char* in_prefix;
  const char* source;
  const char* installed;
};

/// The first file of that name in these folders; empty if there is none.
std::filesystem::path installed_file(const InstalledFolders& folders, const std::string& name);

}  // namespace barreno
