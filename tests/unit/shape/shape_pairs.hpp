// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape/visit_kernels.hpp"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <utility>

namespace barreno::testing {

/// One shape function in one mode; tests run over all pairs of the code's own lists.
template <class M, class S>
struct Pair {
  using Mode = M;
  using Shape = S;
};

template <class Modes, class Shapes>
struct Pairs;
template <class... M, class... S>
struct Pairs<ModeList<M...>, ShapeList<S...>> {
  template <class Mode>
  using Row = std::tuple<Pair<Mode, S>...>;
  template <class... P>
  static ::testing::Types<P...> types(const std::tuple<P...>&);
  using Types = decltype(types(std::tuple_cat(std::declval<Row<M>>()...)));
};
using AllPairs = Pairs<AllModes, AllShapes>::Types;

struct PairNames {
  template <class P>
  // NOLINTNEXTLINE(readability-identifier-naming): GoogleTest's name
  static std::string GetName(int /*number*/) {
    std::string name = P::Shape::word;
    for (char& c : name)
      if (c == ' ' || c == '-') c = '_';
    return name + (P::Mode::hoop ? "_axisymmetric" : P::Mode::dimensions == 2 ? "_plane" : "_3D");
  }
};

}  // namespace barreno::testing
