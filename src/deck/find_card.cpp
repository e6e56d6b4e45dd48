// SPDX-License-Identifier: BSD-3-Clause
#include "deck/find_card.hpp"

#include "base/error.hpp"

#include <barreno/input/nearest_name.hpp>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

namespace barreno {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> directories(const std::string& deck_directory) {
  std::vector<fs::path> result = {
      deck_directory, BARRENO_CARDS_FOLDER, BARRENO_INSTALLED_CARDS_FOLDER};
  if (const char* list = std::getenv("BARRENO_MATERIALS")) {
    std::istringstream stream(list);
    for (std::string directory; std::getline(stream, directory, ':');) {
      if (!directory.empty()) result.emplace_back(directory);
    }
  }
  return result;
}

}  // namespace

std::string find_card(
    const std::string& card, const std::string& deck_directory, const std::string& beside
) {
  std::vector<std::string> known;
  std::error_code ignored;  // a directory that cannot be listed holds no card
  for (const fs::path& directory : directories(deck_directory)) {
    for (const fs::path& candidate : {directory / card, directory / (card + ".xml")})
      if (fs::exists(candidate, ignored) && !fs::is_directory(candidate, ignored))
        return candidate.string();
    for (const auto& file : fs::directory_iterator(directory, ignored)) {
      if (file.path().extension() == ".xml") known.push_back(file.path().filename().string());
    }
  }
  const std::string nearest = input::nearest_name(card, known);
  throw FileError(
      "names no file (it is neither " + beside +
      ", nor in materials/cards, nor in BARRENO_MATERIALS); " +
      (nearest.empty() ? "give the name of a card." : "did you mean '" + nearest + "'?")
  );
}

}  // namespace barreno
