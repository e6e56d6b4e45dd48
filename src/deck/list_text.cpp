// SPDX-License-Identifier: BSD-3-Clause
#include "deck/list_text.hpp"

#include "deck/echo_deck.hpp"

#include <algorithm>

namespace barreno {
namespace {

std::string text_of_list(
    const Teuchos::ParameterList& list, const std::vector<std::string>& names
) {
  std::vector<std::string> lines;
  for (auto item = list.begin(); item != list.end(); ++item) {
    const std::string& name = list.name(item);
    if (!names.empty() && std::find(names.begin(), names.end(), name) == names.end()) continue;
    std::string line = name;
    line += " = ";
    line +=
        list.isSublist(name) ? text_of_list(list.sublist(name), {}) : value_text(list.entry(item));
    lines.push_back(line + "\n");
  }
  std::sort(lines.begin(), lines.end());  // decks may have them in any order
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

}  // namespace

std::string list_text(
    const Deck& deck, const std::string& path, const std::vector<std::string>& names
) {
  return text_of_list(deck.list(path), names);
}

}  // namespace barreno
