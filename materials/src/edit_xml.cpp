// SPDX-License-Identifier: BSD-3-Clause
#include "barreno/input/error.hpp"
#include "barreno/input/nearest_name.hpp"
#include "barreno/input/scan_xml.hpp"
#include "text.hpp"

#include <charconv>

namespace barreno::input {

using Teuchos::XMLObject;

namespace {

std::optional<XMLObject> find_child(
    const XMLObject& list, const char* tag, const std::string& name
) {
  for (int i = 0; i < list.numChildren(); ++i) {
    const XMLObject& child = list.getChild(i);
    if (child.getTag() == tag && child.hasAttribute("name") && child.getAttribute("name") == name) {
      return child;
    }
  }
  return std::nullopt;
}

/// XMLObject is a handle: what is found or added here belongs to the tree.
XMLObject find_or_add(XMLObject& list, const char* tag, const std::string& name) {
  if (const auto child = find_child(list, tag, name)) return *child;
  XMLObject child(tag);
  child.addAttribute("name", name);
  list.addChild(child);
  return child;
}

/// A copy of a list without what the rest of the path names. A tree gives no child back, so the
/// lists on the way are made anew; all others are shared with the first tree.
XMLObject without(
    const XMLObject& list,
    const std::vector<std::string>& names,
    std::size_t level,
    const std::string& assignment
) {
  const bool last = level + 1 == names.size();
  const auto parameter = last ? find_child(list, "Parameter", names[level]) : std::nullopt;
  const char* const tag = parameter ? "Parameter" : "ParameterList";
  if (!find_child(list, tag, names[level])) {
    std::vector<std::string> known;
    for (int i = 0; i < list.numChildren(); ++i)
      if (list.getChild(i).hasAttribute("name"))
        known.push_back(list.getChild(i).getAttribute("name"));
    throw InputError(
        "--set " + shown(assignment) + " removes something that is not there (" +
        shown(names[level]) + "); " + suggest_name(names[level], known)
    );
  }
  XMLObject copy(list.getTag());
  copy.addAttribute("name", list.hasAttribute("name") ? list.getAttribute("name") : "");
  for (int i = 0; i < list.numContentLines(); ++i) copy.addContent(list.getContentLine(i));
  for (int i = 0; i < list.numChildren(); ++i) {
    const XMLObject& child = list.getChild(i);
    const bool named = child.getTag() == tag && child.hasAttribute("name") &&
                       child.getAttribute("name") == names[level];
    if (!named) copy.addChild(child);
    if (named && !last) copy.addChild(without(child, names, level + 1, assignment));
  }
  return copy;
}

}  // namespace

std::optional<std::string> find_text(const XMLObject& list, const std::string& name) {
  const auto child = find_child(list, "Parameter", name);
  if (!child || !child->hasAttribute("value")) return std::nullopt;
  return std::string(trim(child->getAttribute("value")));
}

std::optional<XMLObject> find_list(const XMLObject& list, const std::string& name) {
  return find_child(list, "ParameterList", name);
}

UnitSystem units_of(const XMLObject& root, const std::string& source) {
  const auto text = find_text(root, units_word);
  if (!text) return {};
  try {
    return read_unit_system(*text);
  } catch (const InputError& error) {
    refuse_value(source, units_word, *text, error.what());
  }
}

void set_value(const XMLObject& list, const std::string& name, const std::string& value) {
  XMLObject owner = list;
  XMLObject parameter = find_or_add(owner, "Parameter", name);
  parameter.addAttribute("value", value);
}

XMLObject override_value(
    const XMLObject& root, const std::string& assignment, const std::string& example
) {
  const std::size_t equals = assignment.find('=');
  const auto names = split(assignment.substr(0, equals), '/');
  bool sound = equals != std::string::npos && !names.empty();
  for (const std::string& name : names) sound = sound && !name.empty();
  if (!sound) {
    throw InputError(
        "--set " + shown(assignment) +
        " assigns nothing (a path, '=' and a value are expected here); write for example --set " +
        example + "."
    );
  }
  if (control_character(assignment) >= 0) {
    throw InputError(
        "--set " + shown(assignment) +
        " holds a control character (names and values have none); write it without."
    );
  }
  if (trim(assignment.substr(equals + 1)).empty()) return without(root, names, 0, assignment);
  XMLObject list = root;
  for (std::size_t i = 0; i + 1 < names.size(); ++i)
    list = find_or_add(list, "ParameterList", names[i]);
  set_value(list, names.back(), assignment.substr(equals + 1));
  return root;
}

std::string join(const std::string& path, const std::string& name) {
  return path.empty() ? name : path + "/" + name;
}

std::string exact_text(double value) {
  char buffer[40];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, result.ptr};
}

std::string on_one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return text;
}

std::string shown(const std::string& text) {
  constexpr std::size_t longest = 60;
  const std::string cut = on_one_line(cut_end(text, longest));
  const bool plain =
      !cut.empty() && std::string("0123456789+-.{").find(cut.front()) != std::string::npos;
  return plain ? cut : "\"" + cut + "\"";
}

void refuse(const std::string& source, const std::string& path, const std::string& problem) {
  // Names and words of the user may be of any length; a sentence stays one that can be read.
  constexpr std::size_t longest_path = 300, longest_problem = 2000;
  std::string sentence = source + (path.empty() ? "" : ": " + cut_middle(path, longest_path)) +
                         (problem.empty() ? "" : " " + cut_middle(problem, longest_problem));
  if (sentence.back() != '.' && sentence.back() != '?') sentence += '.';
  throw InputError(on_one_line(sentence));
}

void refuse_value(
    const std::string& source,
    const std::string& path,
    const std::string& text,
    const std::string& problem
) {
  refuse(source, path + " = " + shown(text), problem);
}

}  // namespace barreno::input
