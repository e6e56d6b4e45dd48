// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "odd_values.hpp"
#include "readers.hpp"

#include <optional>
#include <string>
#include <vector>

namespace barreno::fuzz {

/// A list or a parameter of a deck or a card.
struct Node {
  std::string tag;
  std::optional<std::string> name, type, value;
  std::vector<Node> children;
};

/// What changes begin from; XML that can be parsed comes as a tree besides.
struct Seed {
  std::string bytes;
  std::optional<Node> tree;
};
Seed seed_of(Reader reader, const std::string& bytes);

std::string xml_of(const Node& tree, Engine& engine);
/// One change of a tree: a value, a name, a type; a node left out, doubled, moved, put in from
/// another tree or from the tables of what decks know; lists in lists.
void change_tree(Node& tree, const Node& donor, Engine& engine);

/// One change of a table, or of an STL file in text or binary.
std::string changed_table(const std::string& text, char separator, Engine& engine);
std::string changed_binary_surface(const std::string& bytes, Engine& engine);

/// A few changes of a seed, with parts of another one; at most 64 KiB.
std::string mutated(Reader reader, const Seed& seed, const Seed& donor, Engine& engine);

}  // namespace barreno::fuzz
