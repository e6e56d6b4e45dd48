// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "shape/contiguous_gimp.hpp"
#include "shape/cpdi.hpp"
#include "shape/gimp.hpp"
#include "shape/kinematics.hpp"
#include "shape/splines.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace barreno {

template <class... Shapes>
struct ShapeList {};

/// The one list of shape functions; a deck names them by their `word`, and the first is the
/// default.
using AllShapes = ShapeList<Gimp, Linear, ContiguousGimp, Cpdi, QuadraticSpline, CubicSpline>;

namespace detail {

template <class F, class... Shapes>
void for_each_shape(F&& f, ShapeList<Shapes...> /*list*/) {
  (f(Shapes{}), ...);
}

template <class F, class Shape, class... Others>
decltype(auto) visit_shape(const std::string& word, F&& f, ShapeList<Shape, Others...> /*list*/) {
  if constexpr (sizeof...(Others) > 0) {
    if (word != Shape::word) return visit_shape(word, std::forward<F>(f), ShapeList<Others...>{});
  } else if (word != Shape::word) {
    throw std::logic_error("no shape function is called '" + word + "'");
  }
  return std::forward<F>(f)(Shape{});
}

}  // namespace detail

/// f(shape) for every shape function.
template <class F>
void for_each_shape(F&& f) {
  detail::for_each_shape(std::forward<F>(f), AllShapes{});
}

/// f(shape) with the compile-time type that a deck's word names.
template <class F>
decltype(auto) visit_shape(const std::string& word, F&& f) {
  return detail::visit_shape(word, std::forward<F>(f), AllShapes{});
}

/// f(mode, shape): kernels are compiled once for each pair.
template <class F>
decltype(auto) visit_kernels(const Grid& grid, F&& f) {
  return visit_mode(grid.mode, [&](auto mode) {
    return visit_shape(grid.shape, [&](auto shape) { return f(mode, shape); });
  });
}

}  // namespace barreno
