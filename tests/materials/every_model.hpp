// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/models.hpp"
#include "barreno/pore_point.hpp"

#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <variant>

/// The models of barreno/models.hpp as the types of a GoogleTest suite, under their own names.
namespace barreno::test {

template <class Variant>
struct TypesOf;
template <class... Model>
struct TypesOf<std::variant<Model...>> {
  using type = ::testing::Types<Model...>;
};
using AllModels = TypesOf<AnyModel>::type;

/// Those whose fluid a host can move.
template <class Variant, class... Taken>
struct DrainableOf;
template <class... Taken>
struct DrainableOf<std::variant<>, Taken...> {
  using type = ::testing::Types<Taken...>;
};
template <class First, class... Rest, class... Taken>
struct DrainableOf<std::variant<First, Rest...>, Taken...>
    : std::conditional_t<
          is_drainable<First>,
          DrainableOf<std::variant<Rest...>, Taken..., First>,
          DrainableOf<std::variant<Rest...>, Taken...>> {};
using DrainableModels = DrainableOf<AnyModel>::type;

struct ModelName {
  template <class Model>
  // The name that GoogleTest asks for.
  // NOLINTNEXTLINE(readability-identifier-naming)
  static std::string GetName(int) {
    return FullName<Model>::of();
  }
};

}  // namespace barreno::test
