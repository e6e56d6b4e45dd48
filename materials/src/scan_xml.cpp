// SPDX-License-Identifier: BSD-3-Clause
#include "barreno/input/scan_xml.hpp"

#include "barreno/input/error.hpp"
#include "barreno/input/nearest_name.hpp"
#include "text.hpp"

#include <algorithm>
#include <set>

namespace barreno::input {
namespace {

using Teuchos::ParameterList;
using Teuchos::XMLObject;

/// Teuchos' type words that fit a kind; the first is the one to write. Text fits wherever a unit
/// may stand.
std::vector<std::string> types_of(Kind kind) {
  switch (kind) {
    case Kind::number:
      return {"double", "string", "int", "float", "long long"};
    case Kind::integer:
      return {"int", "string", "double", "long long"};
    case Kind::flag:
      return {"bool", "string"};
    case Kind::vector:
      return {"Array(double)", "string", "Array(int)"};
    case Kind::words:
      return {"Array(string)", "string"};
    case Kind::table:
      return {"TwoDArray(double)", "string"};
    default:
      return {"string"};
  }
}

std::string example_value(const Entry& entry) {
  if (!entry.example.empty()) return entry.example;
  switch (entry.kind) {
    case Kind::number:
      return example_of(entry.dimension);
    case Kind::vector:
      return "{" + example_of(entry.dimension) + ", " + example_of(entry.dimension) + "}";
    case Kind::integer:
      return "4";
    case Kind::flag:
      return "true";
    case Kind::word:
      return entry.words.front();
    case Kind::words:
      return "{" + (entry.words.empty() ? "A, B" : entry.words.front()) + "}";
    default:
      return "...";
  }
}

std::string name_of(const XMLObject& xml, const std::string& path, const std::string& source) {
  std::string name = xml.hasAttribute("name") ? xml.getAttribute("name") : "";
  if (trim(name).empty()) {
    refuse(
        source,
        path.empty() ? "the deck" : path,
        "contains a <" + xml.getTag() +
            "> without a name (it cannot be told apart from others); add name=\"...\""
    );
  }
  return name;
}

/// Only lists and parameters, no loose text, and no name twice.
void check_children(const XMLObject& xml, const std::string& path, const std::string& source) {
  const std::string here = path.empty() ? "the deck" : path;
  for (int i = 0; i < xml.numContentLines(); ++i) {
    const std::string_view loose = trim(xml.getContentLine(i));
    if (!loose.empty()) {
      refuse(
          source,
          here,
          "contains the stray text " + shown(std::string(loose)) +
              " (only parameters and lists are read); remove it or make it a comment"
      );
    }
  }
  std::set<std::string> parameters, lists;
  for (int i = 0; i < xml.numChildren(); ++i) {
    const XMLObject& child = xml.getChild(i);
    const bool is_list = child.getTag() == "ParameterList";
    if (!is_list && child.getTag() != "Parameter") {
      refuse(
          source,
          here,
          "contains a <" + child.getTag() +
              "> (only Parameter and ParameterList are read); remove it"
      );
    }
    const std::string name = name_of(child, path, source);
    if (!(is_list ? lists : parameters).insert(name).second) {
      refuse(
          source,
          join(path, name),
          "is given twice (it is unclear which one is meant); remove one of them"
      );
    }
  }
}

void check_type(
    const XMLObject& xml, const Entry& entry, const std::string& path, const std::string& source
) {
  if (!xml.hasAttribute("type")) return;
  const auto types = types_of(entry.kind);
  const std::string& type = xml.getAttribute("type");
  if (std::find(types.begin(), types.end(), type) != types.end()) return;
  refuse(
      source,
      path,
      "has the type '" + type + "', which does not fit (" + entry.meaning + "); write type=\"" +
          types.front() + "\""
  );
}

std::string text_of(const XMLObject& xml, const std::string& path, const std::string& source) {
  if (!xml.hasAttribute("value")) {
    refuse(source, path, "has no value; write value=\"...\"");
  }
  return xml.getAttribute("value");
}

void scan_parameter(
    const XMLObject& xml,
    const Section& section,
    const std::string& path,
    const Source& source,
    ParameterList& list
) {
  const std::string& name = xml.getAttribute("name");
  const auto entry = std::find_if(
      section.entries.begin(), section.entries.end(), [&](const Entry& e) { return e.name == name; }
  );
  if (entry == section.entries.end()) {
    std::vector<std::string> known;
    for (const Entry& e : section.entries) known.push_back(e.name);
    refuse(source.name, join(path, name), "is not a known parameter; " + suggest_name(name, known));
  }
  check_type(xml, *entry, join(path, name), source.name);
  const std::string text = text_of(xml, join(path, name), source.name);
  try {
    put_value(list, *entry, text, source.units);
  } catch (const InputError& error) {
    refuse_value(source.name, join(path, name), text, error.what());
  }
}

/// Absent parameters: refused when required, filled when they have a default.
void complete(
    const Section& section, const std::string& path, const std::string& source, ParameterList& list
) {
  for (const Entry& entry : section.entries) {
    if (list.isParameter(entry.name)) continue;
    if (entry.presence == Presence::required) {
      refuse(
          source,
          join(path, entry.name),
          "is missing (" + entry.meaning + "); add <Parameter name=\"" + entry.name + "\" type=\"" +
              types_of(entry.kind).front() + "\" value=\"" + example_value(entry) + "\"/>"
      );
    }
    if (entry.presence == Presence::defaulted)
      put_value(list, entry, entry.default_text, UnitSystem{});
  }
}

void scan_named_lists(
    const XMLObject& xml,
    const Section& section,
    const std::string& path,
    const Source& source,
    Completeness completeness,
    ParameterList& list
) {
  for (const XMLObject& child : sub_lists(xml, path, source.name)) {
    const std::string& name = child.getAttribute("name");
    const auto fixed =
        std::find_if(section.sections.begin(), section.sections.end(), [&](const Section& s) {
          return s.name == name;
        });
    const bool is_fixed = fixed != section.sections.end();
    if (!is_fixed && section.named.empty()) {
      std::vector<std::string> known;
      for (const Section& s : section.sections) known.push_back(s.name);
      refuse(source.name, join(path, name), "is not a known section; " + suggest_name(name, known));
    }
    if (name.find('/') != std::string::npos) {
      refuse(
          source.name,
          join(path, name),
          "has a '/' in its name (it separates path and name); rename it"
      );
    }
    if (is_fixed ? fixed->read_elsewhere : section.named_read_elsewhere) continue;
    const Section& table = is_fixed ? *fixed : section.named.front();
    list.sublist(name, false, table.meaning) =
        scan_list(child, table, join(path, name), source, completeness);
  }
}

}  // namespace

std::vector<XMLObject> sub_lists(
    const XMLObject& list, const std::string& path, const std::string& source
) {
  check_children(list, path, source);
  std::vector<XMLObject> lists;
  for (int i = 0; i < list.numChildren(); ++i) {
    if (list.getChild(i).getTag() == "ParameterList") lists.push_back(list.getChild(i));
  }
  return lists;
}

ParameterList scan_list(
    const XMLObject& xml,
    const Section& section,
    const std::string& path,
    const Source& source,
    Completeness completeness
) {
  check_children(xml, path, source.name);
  ParameterList list(path.empty() ? section.name : path);
  for (int i = 0; i < xml.numChildren(); ++i) {
    if (xml.getChild(i).getTag() == "Parameter")
      scan_parameter(xml.getChild(i), section, path, source, list);
  }
  if (completeness == Completeness::whole) complete(section, path, source.name, list);
  scan_named_lists(xml, section, path, source, completeness, list);
  if (completeness == Completeness::partial) return list;
  for (const Section& part : section.sections) {
    if (list.isSublist(part.name) || part.presence == Presence::optional) continue;
    if (part.presence == Presence::required) {
      refuse(
          source.name,
          join(path, part.name),
          "is missing (" + part.meaning + "); add <ParameterList name=\"" + part.name + "\">"
      );
    }
    const XMLObject empty("ParameterList");
    list.sublist(part.name, false, part.meaning) =
        scan_list(empty, part, join(path, part.name), source, completeness);
  }
  return list;
}

}  // namespace barreno::input
