// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/part.hpp"
#include "barreno/real.hpp"

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

/// Cap of the surface: hydrostatic strength X and branch point kappa [stress], and the slope of the
/// crush curve there. X = -infinity is never stored: where not `present`, the others mean nothing.
template <class R>
struct CapOf {
  MaskOf<R> present{};
  R X{}, kappa{};
  R slope{};  ///< dX/d(evp) [stress]
};
using Cap = CapOf<double>;

/// 0 on the limit surface and at the branch point, 1 at the end of the cap and beyond.
template <class R>
BARRENO_FUNCTION R place_on_cap(const R& x, const CapOf<R>& cap) {
  const MaskOf<R> on_cap = cap.present & (x < cap.kappa);
  const R span = real::select(on_cap, cap.kappa - cap.X, 1.0);
  return real::select(on_cap, real::smaller(R((cap.kappa - x) / span), 1.0), 0.0);
}

}  // namespace barreno::arenisca
