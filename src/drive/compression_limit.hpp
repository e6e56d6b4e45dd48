// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <type_traits>
#include <utility>

namespace barreno {

template <class Model, class = void>
struct HasShockLimit : std::false_type {};
template <class Model>
struct HasShockLimit<
    Model,
    std::void_t<decltype(std::declval<const Model&>().equation_of_state().compression_limit())>>
    : std::true_type {};

/// What ends a path at the compression limit of the Mie-Grueneisen law, for a sentence; empty for
/// other models and below the limit.
/// @param volume_ratio  V / V_ref that is asked for
/// @param share         of the limit from which a failure is taken for the limit's
template <class Model>
std::string beyond_compression_limit(const Model& model, double volume_ratio, double share = 1.0) {
  if constexpr (HasShockLimit<Model>::value) {
    const auto& law = model.equation_of_state();
    const double limit = law.compression_limit();
    if (!(1.0 - volume_ratio >= share * limit)) return "";
    char smallest[40], largest[40];
    std::snprintf(smallest, sizeof smallest, "%.4g", 1.0 - limit);
    std::snprintf(largest, sizeof largest, "%.4g", -std::log(1.0 - limit));
    return std::string("the compression limit of its Mie-Grueneisen law, V/V0 = ") + smallest +
           (law.slope > 1.0 ? " (no single shock goes beyond 1 - 1/s)" : "") +
           "; stay below a volume strain of " + largest + " (logarithmic)";
  }
  return "";
}

}  // namespace barreno
