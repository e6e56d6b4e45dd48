// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/deck_value.hpp"
#include "deck/section_of.hpp"

#include <any>
#include <barreno/input/schema.hpp>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace barreno {

/// A section of the deck is described once, by the table beside the struct that it fills: name,
/// unit, bounds and meaning of every entry, bound to a member. Validation, manual, effective deck
/// and reading follow from it; a default is what the struct's own initializer says.

/// One entry and the member that it fills.
template <class Spec>
struct BoundEntry {
  input::Entry entry;
  std::any member;  ///< pointer to it; empty: a function reads the entry
  std::function<void(const Deck&, const std::string& path, Spec&)> read;
  std::function<std::string(const Spec&)> text;  ///< of the member, as a deck would say it
  std::string read_by{};                         ///< name of that function
};

template <class Spec>
using Entries = std::vector<BoundEntry<Spec>>;

template <class Spec>
Entries<Spec> joined(const std::vector<Entries<Spec>>& groups) {
  Entries<Spec> all;
  for (const Entries<Spec>& group : groups) all.insert(all.end(), group.begin(), group.end());
  return all;
}

template <class Spec>
struct SectionTable {
  std::string path;     ///< of the section: "Step", "Pore Flow/Rocks"
  std::string meaning;  ///< of the section
  input::Presence presence = input::Presence::required;
  Entries<Spec> entries;
  std::string each{};  ///< meaning of one of its lists of free name, whose entries these are
};

/// A member of a struct's member, where a section fills more than one struct.
template <class Spec, class Part, class T>
struct InnerMember {
  Part Spec::*outer;
  T Part::*inner;
  bool operator==(const InnerMember& other) const {
    return outer == other.outer && inner == other.inner;
  }
};
template <class Spec, class Part, class T>
InnerMember<Spec, Part, T> within(Part Spec::*outer, T Part::*inner) {
  return {outer, inner};
}

template <class Spec, class T>
T& member_of(Spec& spec, T Spec::*member) {
  return spec.*member;
}
template <class Spec, class Part, class T>
T& member_of(Spec& spec, const InnerMember<Spec, Part, T>& member) {
  return (spec.*member.outer).*member.inner;
}

/// From a, which is excluded, to b.
inline Bounds above_up_to(double a, double b) {
  return {a, b, true, false};
}

/// A value with its unit, as a deck of any units may hold it.
inline std::string with_unit(const std::string& value, const input::Entry& entry) {
  const std::string unit = input::si_unit_of(entry.dimension);
  return unit.empty() ? value : value + " " + unit;
}

/// An entry whose value is put into a member as it is.
/// @throws std::logic_error  if the member's type is not what the entry is read as
template <class Spec, class T, class Member>
BoundEntry<Spec> bind_member(Member member, const input::Entry& entry) {
  using input::Kind;
  const Kind kind = DeckValue<T>::kind;
  const bool of_text = kind == Kind::text && (entry.kind == Kind::word || entry.kind == Kind::file);
  if (entry.kind != kind && !of_text)
    throw std::logic_error("the member of '" + entry.name + "' is of another kind");
  BoundEntry<Spec> bound;
  bound.entry = entry;
  bound.member = member;
  bound.read = [member](const Deck& deck, const std::string& path, Spec& spec) {
    member_of(spec, member) = DeckValue<T>::read(deck, path);
  };
  bound.text = [member](const Spec& spec) {
    Spec copy = spec;
    return DeckValue<T>::text(member_of(copy, member));
  };
  return bound;
}
template <class Spec, class T>
BoundEntry<Spec> bind_entry(T Spec::*member, const input::Entry& entry) {
  return bind_member<Spec, T>(member, entry);
}
template <class Spec, class Part, class T>
BoundEntry<Spec> bind_entry(InnerMember<Spec, Part, T> member, const input::Entry& entry) {
  return bind_member<Spec, T>(member, entry);
}

/// The same, of the entry that the member's type makes of name, unit, bounds and meaning.
template <class Spec, class T, class... What>
BoundEntry<Spec> bind_entry(T Spec::*member, const char* name, const What&... what) {
  return bind_member<Spec, T>(member, DeckValue<T>::entry(name, what...));
}
template <class Spec, class Part, class T, class... What>
BoundEntry<Spec> bind_entry(
    InnerMember<Spec, Part, T> member, const char* name, const What&... what
) {
  return bind_member<Spec, T>(member, DeckValue<T>::entry(name, what...));
}

/// A word out of these, for a member that is not an enumeration.
template <class Spec, class T>
BoundEntry<Spec> bind_entry(
    T Spec::*member, const char* name, const Words<T>& words, const char* meaning
) {
  BoundEntry<Spec> bound;
  bound.entry = input::word(name, spelled(words), meaning);
  bound.member = member;
  bound.read = [member, words](const Deck& deck, const std::string& path, Spec& spec) {
    spec.*member = value_at(deck, path, words);
  };
  bound.text = [member, words](const Spec& spec) { return spelling(spec.*member, words); };
  return bound;
}

/// An entry that a deck must have.
template <class Member, class... What>
auto needed(Member member, const What&... what) {
  return bind_entry(member, what...);
}

/// An entry whose default is what its member is before anything is read.
template <class Spec>
BoundEntry<Spec> with_default(BoundEntry<Spec> bound) {
  const std::string value = bound.text(Spec{});
  bound.entry = bound.entry.by_default(value == "0" ? value : with_unit(value, bound.entry));
  return bound;
}
template <class Member, class... What>
auto defaulted(Member member, const What&... what) {
  return with_default(bind_entry(member, what...));
}

/// An entry that may be absent: then its member is left as it is.
template <class Member, class... What>
auto if_given(Member member, const What&... what) {
  auto bound = bind_entry(member, what...);
  bound.entry = bound.entry.if_given();
  return bound;
}

/// An entry that a function of that name reads, for its meaning is more than a value; the member
/// that it fills, if there is one.
template <class Spec>
BoundEntry<Spec> read_by(const char* function, const input::Entry& entry) {
  BoundEntry<Spec> bound;
  bound.entry = entry;
  bound.read_by = function;
  return bound;
}
template <class Spec, class T>
BoundEntry<Spec> read_by(const char* function, T Spec::*member, const input::Entry& entry) {
  BoundEntry<Spec> bound = read_by<Spec>(function, entry);
  bound.member = member;
  return bound;
}

/// What the deck's reader is given of a section's entries, and of the section.
template <class Spec>
std::vector<input::Entry> entries_of() {
  std::vector<input::Entry> entries;
  for (const BoundEntry<Spec>& bound : table_of<Spec>().entries) entries.push_back(bound.entry);
  return entries;
}
template <class Spec>
input::Section section_of() {
  const SectionTable<Spec>& table = table_of<Spec>();
  const std::vector<input::Entry> entries = entries_of<Spec>();
  const std::string name = table.path.substr(table.path.rfind('/') + 1);
  if (table.each.empty()) return {name, table.meaning, table.presence, entries, {}, {}};
  const input::Section list = {"*", table.each, input::Presence::required, entries, {}, {}};
  return {name, table.meaning, table.presence, {}, {}, {list}};
}

/// The table's row of a member.
template <class Spec, class Member>
const BoundEntry<Spec>& row_of(Member member) {
  for (const BoundEntry<Spec>& bound : table_of<Spec>().entries) {
    const auto* const found = std::any_cast<Member>(&bound.member);
    if (found != nullptr && *found == member) return bound;
  }
  throw std::logic_error("no entry of " + table_of<Spec>().path + " fills that member");
}

/// The deck's name of a member.
template <class Spec, class T>
const std::string& name_of(T Spec::*member) {
  return row_of<Spec>(member).entry.name;
}
template <class Spec, class Part, class T>
const std::string& name_of(const InnerMember<Spec, Part, T>& member) {
  return row_of<Spec>(member).entry.name;
}

/// The path of one of a section's lists of free name.
template <class Spec>
std::string list_of(const std::string& name) {
  return input::join(table_of<Spec>().path, name);
}

/// Its place in the deck, in lists of free name in that of this name.
template <class Spec, class T>
std::string path_of(T Spec::*member) {
  return input::join(table_of<Spec>().path, name_of(member));
}
template <class Spec, class T>
std::string path_of(T Spec::*member, const std::string& list) {
  return input::join(list_of<Spec>(list), name_of(member));
}

/// The values of a deck in the list at a path, and the defaults of those that it leaves out.
/// Entries of functions are left to these.
template <class Spec>
Spec read_list(const Deck& deck, const std::string& path) {
  Spec spec;
  for (const BoundEntry<Spec>& bound : table_of<Spec>().entries) {
    const std::string entry = input::join(path, bound.entry.name);
    if (bound.read && deck.has(entry)) bound.read(deck, entry, spec);
  }
  return spec;
}
template <class Spec>
Spec read_section(const Deck& deck) {
  return read_list<Spec>(deck, table_of<Spec>().path);
}

}  // namespace barreno
