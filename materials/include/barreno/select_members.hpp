// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/real.hpp"

#include <type_traits>
#include <utility>

namespace barreno {

// Selections between structures of one point or several (real.hpp), member by member.

namespace members {

/// What any member can be initialised with.
struct Anything {
  template <class T>
  operator T() const;
};
template <class T, class Indices, class = void>
struct TakesThatMany : std::false_type {};
template <class T, std::size_t... i>
struct TakesThatMany<
    T,
    std::index_sequence<i...>,
    std::void_t<decltype(T{(static_cast<void>(i), Anything{})...})>> : std::true_type {};
template <class T, std::size_t n = 1>
constexpr std::size_t count() {
  if constexpr (TakesThatMany<T, std::make_index_sequence<n + 1>>::value)
    return count<T, n + 1>();
  else
    return n;
}

/// f(member of a, member of b) for each member of a structure without a base.
template <class A, class B, class F>
BARRENO_FUNCTION void for_each(const A& a, B& b, const F& f) {
  constexpr std::size_t n = count<A>();
  static_assert(n <= 8, "write one more line for a larger structure");
  if constexpr (n == 1) {
    const auto& [a1] = a;
    auto& [b1] = b;
    f(a1, b1);
  } else if constexpr (n == 2) {
    const auto& [a1, a2] = a;
    auto& [b1, b2] = b;
    f(a1, b1), f(a2, b2);
  } else if constexpr (n == 3) {
    const auto& [a1, a2, a3] = a;
    auto& [b1, b2, b3] = b;
    f(a1, b1), f(a2, b2), f(a3, b3);
  } else if constexpr (n == 4) {
    const auto& [a1, a2, a3, a4] = a;
    auto& [b1, b2, b3, b4] = b;
    f(a1, b1), f(a2, b2), f(a3, b3), f(a4, b4);
  } else if constexpr (n == 5) {
    const auto& [a1, a2, a3, a4, a5] = a;
    auto& [b1, b2, b3, b4, b5] = b;
    f(a1, b1), f(a2, b2), f(a3, b3), f(a4, b4), f(a5, b5);
  } else if constexpr (n == 6) {
    const auto& [a1, a2, a3, a4, a5, a6] = a;
    auto& [b1, b2, b3, b4, b5, b6] = b;
    f(a1, b1), f(a2, b2), f(a3, b3), f(a4, b4), f(a5, b5), f(a6, b6);
  } else if constexpr (n == 7) {
    const auto& [a1, a2, a3, a4, a5, a6, a7] = a;
    auto& [b1, b2, b3, b4, b5, b6, b7] = b;
    f(a1, b1), f(a2, b2), f(a3, b3), f(a4, b4), f(a5, b5), f(a6, b6), f(a7, b7);
  } else {
    const auto& [a1, a2, a3, a4, a5, a6, a7, a8] = a;
    auto& [b1, b2, b3, b4, b5, b6, b7, b8] = b;
    f(a1, b1), f(a2, b2), f(a3, b3), f(a4, b4), f(a5, b5), f(a6, b6), f(a7, b7), f(a8, b8);
  }
}

}  // namespace members

/// Puts `other` in place of `to` where `choice` holds: a number, a mask, or a structure of these.
template <class Mask, class T>
BARRENO_FUNCTION void assign_where(const Mask& choice, const T& other, T& to) {
  if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, LaneMask>)
    to = (choice & other) | ((!choice) & to);
  else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Lanes>)
    to = real::select(choice, other, to);
  else
    members::for_each(other, to, [&](const auto& a, auto& b) { assign_where(choice, a, b); });
}

/// `yes` where `choice` holds, else `no`.
template <class Mask, class T>
BARRENO_INLINED T select_points(const Mask& choice, const T& yes, const T& no) {
  T out = no;
  assign_where(choice, yes, out);
  return out;
}

}  // namespace barreno
