// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"

#include <barreno/describe.hpp>

namespace barreno {

/// A per-particle quantity: values(particle, component) with the name and unit that files carry.
/// A scene that does not need it gives it no components, and then it costs nothing.
struct Field {
  const char* name = "";  ///< a literal: kernels copy fields
  Dimension dimension;
  int components = 0;
  FieldView values;

  KOKKOS_INLINE_FUNCTION double& operator()(int p, int c = 0) const { return values(p, c); }
};

}  // namespace barreno
