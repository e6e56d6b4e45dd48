// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drive/driven_state.hpp"

#include <barreno/models.hpp>
#include <functional>
#include <optional>
#include <string>

namespace barreno {

/// The yield surface of a point in one state, from the material's own functions:
///   sqrt(J2) <= gamma(theta) limit(I1)
/// for the invariants and the Lode angle of the stress `bounded` (docs/method.md).
struct YieldView {
  Sym3 bounded;                         ///< the stress that the surface bounds [Pa]
  double tip, vertex;                   ///< least and greatest I1; infinite where it is open [Pa]
  std::function<double(double)> limit;  ///< sqrt(J2) at an I1 in [tip, vertex], theta = pi/3 [Pa]
  std::function<double(double)> gamma;  ///< of theta in [0, pi/3], 0 in triaxial extension [-]
};

/// Nothing for a material without a yield surface.
/// @param now, before  the state, and the one before it, which gives metals their strain rate; the
///                     same for the first
std::optional<YieldView> yield_view(
    const Material& material, const DrivenState& now, const DrivenState& before
);

/// What the bounded stress is, for legends: "effective stress (stress + pore pressure)".
std::string bounded_stress_words(const Material& material);

}  // namespace barreno
