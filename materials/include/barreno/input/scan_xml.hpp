// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/input/schema.hpp"
#include "barreno/input/units.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_XMLObject.hpp>

#include <optional>
#include <string>
#include <vector>

namespace barreno::input {

/// From Teuchos ParameterList XML to a checked ParameterList in SI.
///
/// The XML is scanned before Teuchos converts a value, because Teuchos' own conversions read "0.3
/// MPa" as 0.3, "abc" as 0 and the integer "1e6" as 1, keep the last of two equal names, name
/// unnamed lists by themselves and do not know required parameters.
///
/// Every refusal is an InputError with one sentence: source, path and value, what is wrong (why),
/// what to do.

/// Where a text came from, for sentences, and the units of its plain numbers.
struct Source {
  std::string name;
  UnitSystem units;
};

/// Larger texts and deeper lists cannot be decks; they are refused before they cost memory or
/// stack.
inline constexpr std::size_t largest_text = 8u << 20u;
inline constexpr int deepest_nesting = 32;

/// The tree of a well-formed text whose root is a ParameterList.
Teuchos::XMLObject parse_xml(const std::string& text, const std::string& source);

/// Required parameters may be absent from a partial list (the overrides of a card), and no default
/// is filled.
enum class Completeness { whole, partial };

/// The values of one list and its sub-lists, checked against the table, in SI, defaults filled.
/// @param path  of this list inside the deck: "" for the root, "Bodies/Casing"
Teuchos::ParameterList scan_list(
    const Teuchos::XMLObject& xml,
    const Section& section,
    const std::string& path,
    const Source& source,
    Completeness completeness = Completeness::whole
);

/// One value, as if it stood in a deck. Throws InputError with the part of the sentence after the
/// value.
void put_value(
    Teuchos::ParameterList& list,
    const Entry& entry,
    const std::string& text,
    const UnitSystem& units
);

/// Text of a parameter of this list, unread; nothing when it is absent.
std::optional<std::string> find_text(const Teuchos::XMLObject& list, const std::string& name);

/// Direct sub-list of that name; nothing when it is absent.
std::optional<Teuchos::XMLObject> find_list(
    const Teuchos::XMLObject& list, const std::string& name
);

/// Direct sub-lists, in the order of the text; names present and unique.
std::vector<Teuchos::XMLObject> sub_lists(
    const Teuchos::XMLObject& list, const std::string& path, const std::string& source
);

/// The system that the list's Units names; SI without it.
UnitSystem units_of(const Teuchos::XMLObject& root, const std::string& source);

/// Sets or adds a parameter of this list, in the tree itself.
void set_value(const Teuchos::XMLObject& list, const std::string& name, const std::string& value);

/// Sets or adds the parameter of "Sub List/Parameter=value"; sub-lists are made as needed.
/// "Sub List/Parameter=", with nothing behind the sign, takes the parameter away, or the list of
/// that name: a default, or what a card says, then counts again. No text of the tables has an empty
/// value that is not also its default.
/// @param example  what could be written instead of an assignment without sense, for sentences
/// @return the tree that holds; values are put into the given one, taking away makes another
/// @throws InputError if nothing is assigned, or what is taken away is not there
Teuchos::XMLObject override_value(
    const Teuchos::XMLObject& root,
    const std::string& assignment,
    const std::string& example = "\"Time/End Time=50 us\""
);

/// "a/b", or "b" when the path is empty.
std::string join(const std::string& path, const std::string& name);

/// Shortest decimal text that reads back as the same double.
std::string exact_text(double value);

/// Line ends and control characters, which names and values of a user may hold, as blanks.
std::string on_one_line(std::string text);

/// A value inside a sentence: numbers and arrays as written, words in quotes, long ones cut.
std::string shown(const std::string& text);

/// Throws InputError("source: path = value problem.").
[[noreturn]] void refuse_value(
    const std::string& source,
    const std::string& path,
    const std::string& text,
    const std::string& problem
);
/// Throws InputError("source: path problem.").
[[noreturn]] void refuse(
    const std::string& source, const std::string& path, const std::string& problem
);

}  // namespace barreno::input
