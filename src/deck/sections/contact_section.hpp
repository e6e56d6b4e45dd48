// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"
#include "deck/words.hpp"

#include <array>
#include <string>

namespace barreno {

/// What the surfaces of two materials do to each other; bonded: what materials without a contact
/// do, they share one velocity.
enum class ContactKind { bonded, stick, friction, frictionless };
inline Words<ContactKind> words_of(ContactKind /*of*/) {
  return {
      {"friction", ContactKind::friction},
      {"frictionless", ContactKind::frictionless},
      {"stick", ContactKind::stick}};
}

/// Entries that name the two materials; pair_at reads them.
inline constexpr const char* material_word = "Material";
inline constexpr const char* other_material_word = "Other Material";

struct ContactSpec {
  std::string name;
  std::array<int, 2> materials{};  ///< indices into Scene::materials, different
  ContactKind kind = ContactKind::frictionless;
  double friction = 0.0;  ///< coefficient of friction [-]
};
template <>
const SectionTable<ContactSpec>& table_of<ContactSpec>();

}  // namespace barreno
