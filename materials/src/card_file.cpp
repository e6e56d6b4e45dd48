// SPDX-License-Identifier: BSD-3-Clause
#include "card_file.hpp"

#include "barreno/input/error.hpp"
#include "barreno/input/nearest_name.hpp"
#include "text.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <set>
#include <vector>

namespace barreno::c_interface {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return text;
}

/// Cards of an installation that was moved: beside the library or program that this code is in.
fs::path moved_cards() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&card_file), &info) == 0 || info.dli_fname == nullptr)
    return {};
  std::error_code ignored;
  const fs::path binary = fs::canonical(info.dli_fname, ignored);
  return (binary.parent_path() / BARRENO_CARDS_FROM_LIBRARY).lexically_normal();
}

std::vector<fs::path> directories() {
  std::vector<fs::path> result;
  if (const char* list = std::getenv("BARRENO_MATERIALS")) {
    for (const std::string& directory : input::split(list, ':')) {
      if (!directory.empty()) result.emplace_back(directory);
    }
  }
  result.push_back(moved_cards());
  result.emplace_back(BARRENO_CARDS_FOLDER);
  result.emplace_back(BARRENO_INSTALLED_CARDS_FOLDER);
  return result;
}

/// Names of the cards in a directory, sorted: a listing has no order of its own.
std::vector<fs::path> cards_in(const fs::path& directory) {
  std::vector<fs::path> cards;
  std::error_code ignored;  // a directory that cannot be listed holds no card
  for (const auto& file : fs::directory_iterator(directory, ignored)) {
    if (file.path().extension() == ".xml") cards.push_back(file.path());
  }
  std::sort(cards.begin(), cards.end());
  return cards;
}

}  // namespace

std::string card_file(const std::string& name) {
  std::error_code ignored;
  for (const std::string& file : {name, name + ".xml"})
    if (fs::is_regular_file(file, ignored)) return file;
  std::string wanted = lower(name);
  if (wanted.size() > 4 && wanted.compare(wanted.size() - 4, 4, ".xml") == 0)
    wanted.resize(wanted.size() - 4);
  std::set<std::string> known;
  for (const fs::path& directory : directories()) {
    for (const fs::path& card : cards_in(directory)) {
      if (lower(card.stem().string()) == wanted) return card.string();
      known.insert(card.stem().string());
    }
  }
  throw FileError(
      "'" + name +
      "' names no card (it is no file, and neither BARRENO_MATERIALS nor the installed cards hold "
      "it); " +
      (known.empty() ? "give the path of a card."
                     : input::suggest_name(name, {known.begin(), known.end()}))
  );
}

}  // namespace barreno::c_interface
