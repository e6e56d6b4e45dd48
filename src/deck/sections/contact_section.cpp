// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/contact_section.hpp"

#include "deck/section_table.hpp"

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

SectionTable<ContactSpec> contact_table() {
  return {
      "Contact",
      "pairs of materials whose surfaces can slide or separate, one freely named list each; all "
      "other materials stick together where they meet",
      Presence::defaulted,
      {read_by<ContactSpec>("pair_at", text(material_word, "name of a list in Materials")),
       read_by<ContactSpec>(
           "pair_at", text(other_material_word, "name of another, which may be of the same Card")
       ),
       needed(
           &ContactSpec::kind,
           "Kind",
           "behaviour along surfaces pressed together; surfaces can always separate"
       ),
       if_given(
           &ContactSpec::friction,
           "Friction Coefficient",
           dim::none,
           at_least(0.0),
           "shear over pressure; only for friction"
       )},
      "one pair of materials"};
}

}  // namespace

template <>
const SectionTable<ContactSpec>& table_of<ContactSpec>() {
  static const SectionTable<ContactSpec> table = contact_table();
  return table;
}

}  // namespace barreno
