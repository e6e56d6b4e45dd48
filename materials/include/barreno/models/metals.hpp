// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/models/voided_metal.hpp"

#include <type_traits>
#include <variant>

namespace barreno {

using JohnsonCook = Metal<JohnsonCookFlow, MieGruneisen, Fracture>;
template <class Solid>
struct ExpandedForm;
template <class Strength, class EquationOfState, class Failure>
struct ExpandedForm<Metal<Strength, EquationOfState, Failure>> {
  using type = Metal<Strength, EquationOfState, Voids<Failure>>;
};
/// The form of a metal that may have voids.
template <class Solid>
using Expanded = typename ExpandedForm<Solid>::type;

/// Metals, with voids or without.
template <class Model>
inline constexpr bool is_metal_model = false;
template <class... Parts>
inline constexpr bool is_metal_model<Metal<Parts...>> = true;

namespace metal {

template <class Strength, class EquationOfState, class Failure>
using FormsOf = std::variant<
    Metal<Strength, EquationOfState, Failure>,
    Metal<Strength, EquationOfState, Voids<Failure>>>;
template <class Strength, class EquationOfState, class FailureList>
struct WithFailures;
template <class Strength, class EquationOfState, class... Failures>
struct WithFailures<Strength, EquationOfState, PartList<Failures...>>
    : JoinedVariants<FormsOf<Strength, EquationOfState, Failures>...> {};
template <class Strength, class EquationList, class FailureList>
struct WithEquations;
template <class Strength, class... Equations, class FailureList>
struct WithEquations<Strength, PartList<Equations...>, FailureList>
    : JoinedVariants<typename WithFailures<Strength, Equations, FailureList>::type...> {};
template <class StrengthList, class EquationList, class FailureList>
struct AllOf;
template <class... Strengths, class EquationList, class FailureList>
struct AllOf<PartList<Strengths...>, EquationList, FailureList>
    : JoinedVariants<typename WithEquations<Strengths, EquationList, FailureList>::type...> {};

}  // namespace metal

/// Every metal that the lists of parts make (metal/list.hpp).
using Metals = metal::AllOf<metal::Strengths, metal::EquationsOfState, metal::Failures>::type;

}  // namespace barreno
