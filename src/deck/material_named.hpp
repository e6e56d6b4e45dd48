// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_table.hpp"
#include "deck/sections/material_section.hpp"

namespace barreno {

/// An entry that names a list in Materials; its member is the material's index.
template <class Spec>
BoundEntry<Spec> material_named(int Spec::*member, const char* name, const char* meaning) {
  BoundEntry<Spec> bound = read_by<Spec>("material_at", input::text(name, meaning));
  bound.member = member;
  bound.read = [member](const Deck& deck, const std::string& path, Spec& spec) {
    spec.*member = material_at(deck, path);
  };
  bound.text = [member](const Spec& spec) { return std::to_string(spec.*member); };
  return bound;
}

}  // namespace barreno
