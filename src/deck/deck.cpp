// SPDX-License-Identifier: BSD-3-Clause
#include "deck/deck.hpp"

#include "deck/echo_deck.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/material_section.hpp"

#include <Teuchos_TwoDArray.hpp>

#include <barreno/input/scan_xml.hpp>

namespace barreno {
namespace {

struct Located {
  const Teuchos::ParameterList* list;  ///< null when a list on the way is absent
  std::string name;
};

Located locate(const Teuchos::ParameterList& values, const std::string& path) {
  const Teuchos::ParameterList* list = &values;
  std::size_t begin = 0;
  for (std::size_t end = path.find('/'); end != std::string::npos; end = path.find('/', begin)) {
    const std::string name = path.substr(begin, end - begin);
    if (!list->isSublist(name)) return {nullptr, ""};
    list = &list->sublist(name);
    begin = end + 1;
  }
  return {list, path.substr(begin)};
}

}  // namespace

template <class T>
T Deck::get(const std::string& path) const {
  const auto [list, name] = locate(values_, path);
  // The tables put every value here; a missing one is a mistake of the code, not of the deck.
  if (list == nullptr || !list->isType<T>(name)) throw std::logic_error("no value at " + path);
  return list->get<T>(name);
}

bool Deck::has(const std::string& path) const {
  const auto [list, name] = locate(values_, path);
  return list != nullptr && list->isParameter(name);
}

std::vector<std::string> Deck::lists(const std::string& path) const {
  std::vector<std::string> names;
  const auto [parent, name] = locate(values_, path);
  if (parent == nullptr || !parent->isSublist(name)) return names;
  const Teuchos::ParameterList& list = parent->sublist(name);
  for (auto item = list.begin(); item != list.end(); ++item) {
    if (list.entry(item).isList()) names.push_back(list.name(item));
  }
  return names;
}

double Deck::number(const std::string& path) const {
  return get<double>(path);
}
int Deck::integer(const std::string& path) const {
  return get<int>(path);
}
bool Deck::flag(const std::string& path) const {
  return get<bool>(path);
}
std::string Deck::word(const std::string& path) const {
  return get<std::string>(path);
}
bool Deck::holds_word(const std::string& path) const {
  const auto [list, name] = locate(values_, path);
  return list != nullptr && list->isType<std::string>(name);
}
std::vector<std::string> Deck::words(const std::string& path) const {
  return get<Teuchos::Array<std::string>>(path).toVector();
}
std::vector<double> Deck::vector(const std::string& path) const {
  return get<Teuchos::Array<double>>(path).toVector();
}

std::vector<std::vector<double>> Deck::rows(const std::string& path) const {
  const auto table = get<Teuchos::TwoDArray<double>>(path);
  std::vector<std::vector<double>> rows;
  for (Teuchos::TwoDArray<double>::size_type i = 0; i < table.getNumRows(); ++i) {
    rows.emplace_back(table[i].begin(), table[i].end());
  }
  return rows;
}

Teuchos::ParameterList Deck::list(const std::string& path) const {
  const auto [parent, name] = locate(values_, path);
  if (parent == nullptr || !parent->isSublist(name)) return {};
  return parent->sublist(name);
}

void Deck::refuse_value(const std::string& path, const std::string& problem) const {
  Teuchos::XMLObject xml = xml_;
  std::size_t begin = 0;
  std::size_t end = path.find('/');
  for (; end != std::string::npos; end = path.find('/', begin)) {
    const auto list = input::find_list(xml, path.substr(begin, end - begin));
    if (!list) break;
    xml = *list;
    begin = end + 1;
  }
  auto text = end == std::string::npos ? input::find_text(xml, path.substr(begin)) : std::nullopt;
  if (!text) {
    const auto [list, name] = locate(values_, path);
    if (list != nullptr && list->isParameter(name)) text = value_text(list->getEntry(name));
  }
  input::refuse_value(name_, path, text.value_or(""), problem);
}

void Deck::refuse(const std::string& path, const std::string& problem) const {
  input::refuse(name_, path, problem);
}

}  // namespace barreno
