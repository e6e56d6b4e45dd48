// SPDX-License-Identifier: BSD-3-Clause
#include "mutate.hpp"

#include <barreno/input/scan_xml.hpp>

namespace barreno::fuzz {
namespace {

using Nodes = std::vector<Node*>;

void collect(Node& node, Nodes& all, Nodes& lists) {
  all.push_back(&node);
  if (node.tag == "ParameterList") lists.push_back(&node);
  for (Node& child : node.children) collect(child, all, lists);
}

Node copy_of(const Teuchos::XMLObject& xml) {
  const auto attribute = [&](const char* name) -> std::optional<std::string> {
    if (!xml.hasAttribute(name)) return {};
    return xml.getAttribute(name);
  };
  Node node{xml.getTag(), attribute("name"), attribute("type"), attribute("value"), {}};
  for (int i = 0; i < xml.numChildren(); ++i) node.children.push_back(copy_of(xml.getChild(i)));
  return node;
}

std::string escaped(const std::string& text, Engine& engine) {
  if (one_in(engine, 200)) return text;
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

void write(const Node& node, Engine& engine, std::string& text) {
  text += "<" + node.tag;
  if (node.name) text += " name=\"" + escaped(*node.name, engine) + "\"";
  if (node.type) text += " type=\"" + escaped(*node.type, engine) + "\"";
  if (node.value) text += " value=\"" + escaped(*node.value, engine) + "\"";
  if (node.children.empty()) {
    text += "/>\n";
    return;
  }
  text += ">\n";
  for (const Node& child : node.children) write(child, engine, text);
  text += "</" + node.tag + ">\n";
}

Node known_node(Engine& engine) {
  const Known& known = any_of(engine, known_parameters());
  return {"Parameter", known.name, {}, known.value, {}};
}

void put(Node& list, Node node, Engine& engine) {
  const auto at = static_cast<std::ptrdiff_t>(below(engine, list.children.size() + 1));
  list.children.insert(list.children.begin() + at, std::move(node));
}

void leave_one_out(Node& list, Engine& engine) {
  if (list.children.empty()) return;
  const auto at = static_cast<std::ptrdiff_t>(below(engine, list.children.size()));
  list.children.erase(list.children.begin() + at);
}

void nest(Node& list, Engine& engine) {
  for (std::size_t i = one_in(engine, 10) ? 40 : 1 + below(engine, 3); i > 0; --i) {
    Node inner = list;
    if (i > 3) inner.children.clear();
    list.children.assign(1, inner);
  }
}

void rename(Node& node, const Nodes& all, Engine& engine) {
  static const std::vector<std::string> tags = {"ParameterList", "Parameter", "parameter", "a"};
  static const std::vector<std::string> types = {
      "double",
      "int",
      "string",
      "bool",
      "Array(double)",
      "Array(string)",
      "TwoDArray(double)",
      "x"};
  switch (below(engine, 6)) {
    case 0:
      node.tag = any_of(engine, tags);
      break;
    case 1:
      node.type = any_of(engine, types);
      break;
    case 2:
      node.name = any_of(engine, all)->name;
      break;
    case 3:
      node.name = any_of(engine, known_parameters()).name;
      break;
    case 4:
      node.name =
          one_in(engine, 4) ? odd_value(engine) : changed_bytes(node.name.value_or(""), engine);
      break;
    default:
      (one_in(engine, 2) ? node.name : node.value).reset();
  }
}

void change_value(Node& node, const Nodes& all, Engine& engine) {
  switch (below(engine, 4)) {
    case 0:
      node.value = odd_value(engine);
      break;
    case 1:
      node.value = any_of(engine, all)->value;
      break;
    default:
      node.value = changed_value(node.value.value_or(""), engine);
  }
  if (one_in(engine, 2)) node.type.reset();
}

}  // namespace

Seed seed_of(Reader reader, const std::string& bytes) {
  Seed seed{bytes, {}};
  if (reader != Reader::deck && reader != Reader::card) return seed;
  try {
    seed.tree = copy_of(input::parse_xml(bytes, "seed"));
  } catch (const std::exception&) {  // its bytes are changed alone
  }
  return seed;
}

std::string xml_of(const Node& tree, Engine& engine) {
  std::string text;
  write(tree, engine, text);
  return text;
}

void change_tree(Node& tree, const Node& donor, Engine& engine) {
  Nodes all, lists, donors, donor_lists;
  collect(tree, all, lists);
  Node other = donor;
  collect(other, donors, donor_lists);
  Node& node = *any_of(engine, all);
  if (lists.empty()) return change_value(node, all, engine);
  Node& list = *any_of(engine, lists);
  switch (below(engine, 16)) {
    case 0:
      return leave_one_out(list, engine);
    case 1:
      return put(list, Node(node), engine);
    case 2:
      return put(list, *any_of(engine, one_in(engine, 2) ? donors : donor_lists), engine);
    case 3:
    case 4:
      return put(list, known_node(engine), engine);
    case 5:
      if (one_in(engine, 4)) nest(list, engine);
      return;
    case 6:
    case 7:
      return rename(node, all, engine);
    case 8: {
      Node& second = *any_of(engine, all);
      return std::swap(node.value, second.value);
    }
    default:
      return change_value(node, all, engine);
  }
}

}  // namespace barreno::fuzz
