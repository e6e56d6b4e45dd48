// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/part.hpp"

namespace barreno::arenisca {

/// Where the cap leaves the limit surface: an ellipse from there to the hydrostatic strength X, see
/// SurfaceOf.
struct CapShape {
  struct Parameters {
    double CR;
  };
  static ParameterTable<Parameters> parameter_table() {
    using P = Parameters;
    namespace d = dimension;
    return {
        {optional(&P::CR, "CR", d::none, Bounds{0.0, 1.0, false, true}, 0.5, "shape of the cap")},
        {}};
  }
  static std::string check(const Parameters& /*p*/) { return {}; }
};

}  // namespace barreno::arenisca
