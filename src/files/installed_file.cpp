// SPDX-License-Identifier: BSD-3-Clause
#include "files/installed_file.hpp"

#include <system_error>
#include <vector>

namespace barreno {

std::filesystem::path installed_file(const InstalledFolders& folders, const std::string& name) {
  namespace fs = std::filesystem;
  std::vector<fs::path> places;
  std::error_code ignored;
  fs::path folder = fs::canonical("/proc/self/exe", ignored).parent_path();
  constexpr int deepest = 2;  // bin, or a folder in it
  for (int i = 0; i < deepest && folder.has_relative_path(); ++i) {
    folder = folder.parent_path();
    places.push_back(folder / folders.in_prefix);
  }
  places.emplace_back(folders.source);
  places.emplace_back(folders.installed);
  for (const fs::path& place : places)
    if (fs::exists(place / name, ignored)) return place / name;
  return {};
}

}  // namespace barreno
