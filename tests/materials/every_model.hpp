// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/models.hpp"

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

template <class Model, class = void>
struct FormName {
  static constexpr const char* value = "";
};
template <class Model>
struct FormName<Model, std::void_t<typename Model::SpecialForm>> {
  static constexpr const char* value = "General";
};

struct ModelName {
  template <class Model>
  // The name that GoogleTest asks for.
  // NOLINTNEXTLINE(readability-identifier-naming)
  static std::string GetName(int) {
    return std::string(FormName<Model>::value) + Model::name;
  }
};

}  // namespace barreno::test
