// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/describe.hpp"

#include <variant>

namespace barreno {

// A law made of parts. A part owns everything about itself: its Parameters with name, unit, bounds
// and meaning (parameter_table), the rules between them (check), its history, and its evaluation
// over R, one point or several (real.hpp). A model is joined from its parts.

template <class... Parts>
struct PartList {};
template <class A, class B>
struct JoinedLists;
template <class... As, class... Bs>
struct JoinedLists<PartList<As...>, PartList<Bs...>> {
  using type = PartList<As..., Bs...>;
};

template <class List>
struct ParametersOf;
template <class... Parts>
struct ParametersOf<PartList<Parts...>> : Parts::Parameters... {};

/// f(part) for each part of a list, as a pointer that holds nothing.
template <class... Parts, class F>
void for_each_part(PartList<Parts...> /*list*/, const F& f) {
  (f(static_cast<const Parts*>(nullptr)), ...);
}

/// Appends the table of a part to that of a whole, which inherits the part's parameters.
template <class Whole, class Part>
void add_table(const ParameterTable<Part>& part, ParameterTable<Whole>& whole) {
  for (const auto& n : part.numbers)
    whole.numbers.push_back(
        {n.member, n.name, n.dimension, n.bounds, n.meaning, n.required, n.default_value}
    );
  for (const auto& c : part.choices)
    whole.choices.push_back({c.member, c.name, c.words, c.default_index, c.meaning});
}

/// A name made of several.
struct JoinedText {
  char letters[192] = "";
};
template <class... Parts>
constexpr JoinedText joined_text(const Parts*... parts) {
  JoinedText text;
  int at = 0;
  for (const char* part : {parts...})
    for (; *part != '\0'; ++part) text.letters[at++] = *part;
  return text;
}

template <class... Variants>
struct JoinedVariants;
template <class... As>
struct JoinedVariants<std::variant<As...>> {
  using type = std::variant<As...>;
};
template <class... As, class... Bs, class... Rest>
struct JoinedVariants<std::variant<As...>, std::variant<Bs...>, Rest...>
    : JoinedVariants<std::variant<As..., Bs...>, Rest...> {};

}  // namespace barreno
