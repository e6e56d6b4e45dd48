// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/outcome.hpp"
#include "barreno/tensor.hpp"

#include <type_traits>

namespace barreno {

/// What the pore fluid of a point offers to a flow between points.
struct PorePoint {
  double pressure = 0.0, biot = 1.0, storage = 0.0, porosity = 0.0, fluid_mass = 1.0;
};
template <class Model, class = void>
inline constexpr bool is_drainable = false;
template <class Model>
inline constexpr bool is_drainable<Model, std::void_t<decltype(&Model::drain)>> = true;

}  // namespace barreno
