// SPDX-License-Identifier: BSD-3-Clause
#include "barreno/find_card.hpp"

#include "barreno/input/error.hpp"
#include "barreno/input/nearest_name.hpp"
#include "barreno/input/scan_xml.hpp"
#include "barreno/models.hpp"
#include "barreno/registry.hpp"
#include "text.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <set>
#include <vector>

namespace barreno {
namespace {

namespace fs = std::filesystem;

/// In the case of hosts that do not keep it, and without the ending.
std::string plain_name(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  const std::string ending = ".xml";
  const bool ends = name.size() > ending.size() &&
                    name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
  return ends ? name.substr(0, name.size() - ending.size()) : name;
}

/// Cards of an installation that was moved: it is a folder or two above the library or program that
/// this code is in.
std::vector<fs::path> moved_cards() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&find_card), &info) == 0 || info.dli_fname == nullptr)
    return {};
  constexpr int deepest = 3;  // lib/x86_64-linux-gnu
  std::vector<fs::path> places;
  std::error_code ignored;
  fs::path folder = fs::canonical(info.dli_fname, ignored).parent_path();
  for (int i = 0; i < deepest && folder.has_relative_path(); ++i) {
    folder = folder.parent_path();
    places.push_back(folder / BARRENO_CARDS_IN_PREFIX);
  }
  return places;
}

std::vector<fs::path> directories() {
  std::vector<fs::path> result;
  if (const char* list = std::getenv("BARRENO_MATERIALS")) {
    for (const std::string& directory : input::split(list, ':')) {
      if (!directory.empty()) result.emplace_back(directory);
    }
  }
  for (const fs::path& directory : moved_cards()) result.push_back(directory);
  result.emplace_back(BARRENO_CARDS_FOLDER);
  result.emplace_back(BARRENO_INSTALLED_CARDS_FOLDER);
  return result;
}

/// Cards of a directory, sorted: the order of a listing is arbitrary.
std::vector<fs::path> cards_in(const fs::path& directory) {
  std::vector<fs::path> cards;
  std::error_code ignored;  // a directory that cannot be listed holds no card
  for (const auto& file : fs::directory_iterator(directory, ignored)) {
    if (file.path().extension() == ".xml") cards.push_back(file.path());
  }
  std::sort(cards.begin(), cards.end());
  return cards;
}

/// The card in exactly these letters, with or without ending; empty if there is none. What kind of
/// file it is, its reader says.
fs::path card_at(const fs::path& directory, const std::string& card) {
  std::error_code ignored;
  for (const fs::path& file : {directory / card, directory / (card + ".xml")})
    if (fs::exists(file, ignored) && !fs::is_directory(file, ignored)) return file;
  return {};
}

/// What to do about a name that no card has. A directory of the user's may hold much else, so its
/// files are named only if they are meant.
std::string advice(
    const std::string& card, const fs::path& directory, const std::set<std::string>& known
) {
  std::vector<std::string> names(known.begin(), known.end());
  std::vector<std::string> all = names;
  for (const fs::path& file : cards_in(directory.empty() ? "." : directory))
    all.push_back(file.stem().string());
  const std::string nearest = input::nearest_name(plain_name(card), all);
  if (!nearest.empty()) return "did you mean '" + nearest + "'?";
  return names.empty() ? "give the path of a card." : input::suggest_name(card, names);
}

}  // namespace

std::string find_card(
    const std::string& card, const std::string& directory, const std::string& beside
) {
  if (const fs::path file = card_at(directory, card); !file.empty()) return file.string();
  const std::string wanted = plain_name(card);
  std::set<std::string> known;
  for (const fs::path& folder : directories()) {
    if (const fs::path file = card_at(folder, card); !file.empty()) return file.string();
    for (const fs::path& file : cards_in(folder)) {
      if (plain_name(file.filename().string()) == wanted) return file.string();
      known.insert(file.stem().string());
    }
  }
  throw FileError(
      "names no card (there is none of that name " + beside +
      ", in BARRENO_MATERIALS or among those that Barreno comes with); " +
      advice(card, directory, known)
  );
}

std::string named_card(const std::string& card) {
  if (card.empty()) throw FileError("no card is named; give the path or the name of a card.");
  try {
    return find_card(card);
  } catch (const FileError& error) {
    throw FileError(input::shown(card) + " " + error.what());
  }
}

Material material_open(const std::string& card) {
  return read_card(named_card(card));
}

}  // namespace barreno
