// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace barreno {

/// Physical dimension as powers of length, time, mass and temperature; used for unit suffixes.
struct Dimension {
  int length = 0, time = 0, mass = 0, temperature = 0;
};
inline bool operator==(const Dimension& a, const Dimension& b) {
  return a.length == b.length && a.time == b.time && a.mass == b.mass &&
         a.temperature == b.temperature;
}

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension length{1, 0, 0, 0};
inline constexpr Dimension area{2, 0, 0, 0};
inline constexpr Dimension volume{3, 0, 0, 0};
inline constexpr Dimension time{0, 1, 0, 0};
inline constexpr Dimension mass{0, 0, 1, 0};
inline constexpr Dimension temperature{0, 0, 0, 1};
inline constexpr Dimension velocity{1, -1, 0, 0};
inline constexpr Dimension density{-3, 0, 1, 0};
inline constexpr Dimension stress{-1, -2, 1, 0};
inline constexpr Dimension viscosity{-1, -1, 1, 0};
inline constexpr Dimension compliance{1, 2, -1, 0};
inline constexpr Dimension rate{0, -1, 0, 0};
inline constexpr Dimension specific_energy{2, -2, 0, 0};
inline constexpr Dimension heat_capacity{2, -2, 0, -1};
inline constexpr Dimension energy_per_area{0, -2, 1, 0};
}  // namespace dimension

/// Interval of allowed values; each end open or closed.
struct Bounds {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_open = true, upper_open = true;
  bool contain(double x) const {
    return (lower_open ? x > lower : x >= lower) && (upper_open ? x < upper : x <= upper);
  }
};
inline Bounds any() {
  return {};
}
inline Bounds above(double a) {
  return {a, std::numeric_limits<double>::infinity(), true, true};
}
inline Bounds at_least(double a) {
  return {a, std::numeric_limits<double>::infinity(), false, true};
}
inline Bounds between(double a, double b) {
  return {a, b, false, false};
}

/// One numeric parameter of a model: the single source for validation, manual, C interface order.
template <class P>
struct ParameterEntry {
  double P::*member;
  const char* name;
  Dimension dimension;
  Bounds bounds;
  const char* meaning;
  bool required = true;
  double default_value = 0.0;
};
template <class P>
ParameterEntry<P> required(
    double P::*member, const char* name, Dimension dimension, Bounds bounds, const char* meaning
) {
  return {member, name, dimension, bounds, meaning, true, 0.0};
}
template <class P>
ParameterEntry<P> optional(
    double P::*member,
    const char* name,
    Dimension dimension,
    Bounds bounds,
    double value,
    const char* meaning
) {
  return {member, name, dimension, bounds, meaning, false, value};
}

/// One parameter that takes a word out of a list; stored as the word's index.
template <class P>
struct ChoiceEntry {
  int P::*member;
  const char* name;
  std::vector<std::string> words;
  int default_index;
  const char* meaning;
};

template <class P>
struct ParameterTable {
  std::vector<ParameterEntry<P>> numbers;
  std::vector<ChoiceEntry<P>> choices;
};

/// One internal variable of a model, a double; the order is that of the History struct.
struct HistoryField {
  const char* name;  ///< snake_case, as in Exodus, restart and drive files
  Dimension dimension;
  const char* meaning;
};

}  // namespace barreno
