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

/// Those for which Holds<Model>::value.
template <template <class> class Holds, class Variant, class... Taken>
struct ModelsOf;
template <template <class> class Holds, class... Taken>
struct ModelsOf<Holds, std::variant<>, Taken...> {
  using type = ::testing::Types<Taken...>;
};
template <template <class> class Holds, class First, class... Rest, class... Taken>
struct ModelsOf<Holds, std::variant<First, Rest...>, Taken...>
    : std::conditional_t<
          Holds<First>::value,
          ModelsOf<Holds, std::variant<Rest...>, Taken..., First>,
          ModelsOf<Holds, std::variant<Rest...>, Taken...>> {};

template <class Model>
using HasFluid = std::bool_constant<is_drainable<Model>>;
/// Those whose fluid a host can move.
using DrainableModels = ModelsOf<HasFluid, AnyModel>::type;

struct ModelName {
  template <class Model>
  // The name that GoogleTest asks for.
  // NOLINTNEXTLINE(readability-identifier-naming)
  static std::string GetName(int) {
    return FullName<Model>::of();
  }
};

}  // namespace barreno::test
