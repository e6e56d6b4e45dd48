// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/crush_curve.hpp"
#include "barreno/arenisca/elasticity.hpp"
#include "barreno/arenisca/root_finding.hpp"
#include "barreno/arenisca/yield_surface.hpp"
#include "barreno/tensor.hpp"

#include <cmath>

namespace barreno::arenisca {

/// Everything about the material that a point update reads.
struct Rock {
  static constexpr bool wet = false;        ///< no pore fluid
  static constexpr bool scattered = false;  ///< every piece has the same strength
  static constexpr bool angled = false;     ///< no dependence on the third invariant
  static constexpr bool rated = false;      ///< no overstress

  Elasticity elasticity;
  YieldSurface surface;
  CrushCurve crush;
  CrushRates rates;         ///< of the crush curve
  Cap first_cap;            ///< cap of the virgin rock; compaction only widens it
  double beta;              ///< nonassociativity: scales r in the transformed space
  double tolerance;         ///< relative local error of a substep
  double stress_floor;      ///< below this the local error is measured against it [stress]
  bool bisection;           ///< the paper's return instead of the fast one
  double resolution = 0.0;  ///< of the bisections; 0: the last bit. Benchmarks set it

  BARRENO_FUNCTION Cap cap_at(double evp) const {
    return crush.has_cap(evp) ? surface.cap_at(crush.strength(evp)) : Cap{};
  }
};

/// Bulk moduli of what fills a volume of saturated rock [stress].
struct Constituents {
  double matrix = 0.0;  ///< Km, of the grains
  double fluid = 0.0;   ///< Kf
  double per_matrix = 0.0, per_fluid = 0.0;
};

/// Rock with fluid in its pores: the dry rock for the effective stress, and what fills the rest.
struct WetRock : Rock {
  static constexpr bool wet = true;

  Constituents constituents;
  double initial_pressure = 0.0;  ///< of the fluid in virgin rock [stress]
  double porosity = 0.0;          ///< of virgin rock
};

/// Size of a stress: sqrt(sigma : sigma).
BARRENO_FUNCTION double stress_size(double x, double q) {
  return std::sqrt(x * x / 3.0 + 2.0 * q * q);
}

}  // namespace barreno::arenisca
