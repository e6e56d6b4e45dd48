// SPDX-License-Identifier: BSD-3-Clause
#include "output/copy_surfaces.hpp"

#include "base/digest.hpp"
#include "base/error.hpp"
#include "files/text_file.hpp"

#include <fstream>
#include <iterator>
#include <system_error>

namespace barreno {

void copy_surfaces(const std::vector<SurfaceFile>& files, const std::filesystem::path& folder) {
  for (const SurfaceFile& file : files) {
    const std::filesystem::path copy = folder / file.copy;
    std::error_code none;
    if (std::filesystem::equivalent(file.original, copy, none)) continue;  // of a resumed run
    std::ifstream stream(file.original, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream || digest_of(text) != file.digest)
      throw FileError(
          "the surface '" + file.original + "' has changed since the deck was read (its copy in '" +
          folder.string() + "' would differ); start the run again."
      );
    write_whole_file(copy, text);
  }
}

}  // namespace barreno
