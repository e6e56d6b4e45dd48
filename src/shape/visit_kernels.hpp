// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape/gimp.hpp"
#include "shape/kinematics.hpp"

#include <utility>

namespace barreno {

/// f(shape) with the compile-time type that a deck's word names: the one list of shape functions.
template <class F>
decltype(auto) visit_shape(ShapeFunction shape, F&& f) {
  switch (shape) {
    case ShapeFunction::gimp:
      break;
  }
  return std::forward<F>(f)(Gimp{});
}

/// f(mode, shape): kernels are compiled once for each pair.
template <class F>
decltype(auto) visit_kernels(const Scene& scene, F&& f) {
  return visit_mode(scene.grid.mode, [&](auto mode) {
    return visit_shape(scene.step.shape, [&](auto shape) { return f(mode, shape); });
  });
}

}  // namespace barreno
