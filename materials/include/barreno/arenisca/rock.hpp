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

/// State of a point between substeps.
struct PointState {
  double x;  ///< I1 [stress]
  Sym3 s;    ///< stress deviator [stress]
  double evp, shear_strain;
};

/// What a substep starts from and what it is asked: strain increment in volume and deviator.
struct Substep {
  const PointState& n;
  const Cap& cap;  ///< of the start
  double dv;
  const Sym3& de;
};

/// Elastic predictor of a substep and the moduli at its start and as used.
struct Prediction {
  double x;
  Sym3 s;
  double J2;
  Moduli start, used;
  Elasticity::PressureTerm term{};  ///< pressure dependence at the start
  double coupling = 0.0;            ///< elastic-plastic coupling at the start [stress]
  double evp = 0.0;                 ///< plastic strain the moduli were taken at
  BARRENO_FUNCTION double q() const { return std::sqrt(J2); }
};

/// Result of one attempt at a substep.
struct Attempt {
  PointState end{};
  double error = 0.0;                             ///< estimated local error [stress]
  double allowed = 0.0;                           ///< what it may be [stress]
  int order = 2;                                  ///< power of the step size in `error`
  double elastic_work = 0.0, plastic_work = 0.0;  ///< per current volume [stress]
  Moduli moduli{};                                ///< tangent moduli at the end
};

/// Size of a stress: sqrt(sigma : sigma).
BARRENO_FUNCTION double stress_size(double x, double q) {
  return std::sqrt(x * x / 3.0 + 2.0 * q * q);
}

BARRENO_FUNCTION double allowed_error(
    const Rock& rock, const PointState& n, double x_end, double q_end
) {
  const double start = stress_size(n.x, std::sqrt(second_invariant(n.s)));
  return rock.tolerance * larger(larger(start, stress_size(x_end, q_end)), rock.stress_floor);
}

BARRENO_FUNCTION Prediction predict_with(
    const PointState& n, const Moduli& start, const Moduli& used, double dv, const Sym3& de
) {
  Prediction p{n.x + 3.0 * used.bulk * dv, n.s + (2.0 * used.shear) * de, 0.0, start, used};
  p.J2 = second_invariant(p.s);
  return p;
}

/// How far the moduli used are from the mean of those at both ends, relative.
BARRENO_FUNCTION double moduli_mismatch(const Prediction& p, const Moduli& end) {
  const double bulk = std::fabs(0.5 * (p.start.bulk + end.bulk) / p.used.bulk - 1.0);
  const double shear = std::fabs(0.5 * (p.start.shear + end.shear) / p.used.shear - 1.0);
  return larger(bulk, shear);
}

}  // namespace barreno::arenisca
