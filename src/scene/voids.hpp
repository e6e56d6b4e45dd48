// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>
#include <utility>

namespace barreno {

/// Models whose points may have voids: expanded_state(solid over mean density)
/// (barreno/models/voided_metal.hpp).
template <class Model, class = void>
inline constexpr bool holds_voids = false;
template <class Model>
inline constexpr bool
    holds_voids<Model, std::void_t<decltype(std::declval<const Model&>().expanded_state(1.0))>> =
        true;

/// Models whose volume holds voids at times, of whatever size: expanded_ratio(volume ratio,
/// history) is that of what is between them.
template <class Model, class = void>
inline constexpr bool opens_voids = false;
template <class Model>
inline constexpr bool opens_voids<
    Model,
    std::void_t<decltype(Model::expanded_ratio(0.0, std::declval<const typename Model::History&>())
    )>> = true;

}  // namespace barreno
