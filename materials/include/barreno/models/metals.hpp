// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/models/voided_metal.hpp"

#include <type_traits>
#include <variant>

namespace barreno {

using JohnsonCook = Metal<JohnsonCookFlow, MieGruneisen, Fracture>;
/// The form of a metal that may have voids.
template <class Solid>
using Expanded = typename Solid::WithVoids;

/// Metals, with voids or without.
template <class Model>
inline constexpr bool is_metal_model = false;
template <class... Parts>
inline constexpr bool is_metal_model<Metal<Parts...>> = true;

namespace metal {

template <class... Variants>
using Joined = typename JoinedVariants<Variants...>::type;

// Every strength with every equation of state and failure, without voids and with them.
template <class S, class E, class... F>
Joined<std::variant<Metal<S, E, F>, Metal<S, E, Voids<F>>>...> with_failures(PartList<F...>);
template <class S, class... E>
Joined<decltype(with_failures<S, E>(Failures{}))...> with_equations(PartList<E...>);
template <class... S>
Joined<decltype(with_equations<S>(EquationsOfState{}))...> with_strengths(PartList<S...>);

}  // namespace metal

/// Every metal that the lists of parts make (metal/list.hpp).
using Metals = decltype(metal::with_strengths(metal::Strengths{}));

}  // namespace barreno
