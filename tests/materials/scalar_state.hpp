// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <barreno/arenisca/rock.hpp>
#include <barreno/arenisca/root_finding.hpp>
#include <barreno/models/arenisca.hpp>
#include <cmath>

// The dry law of Arenisca once more, for one point and written apart from that of the library
// (barreno/arenisca/points_step.hpp): what tests and benchmarks compare that one with. It can take
// the published nested bisection instead of the fast return.
namespace barreno::arenisca {

/// False for NaN, infinite or absurd input: a strain increment beyond exp(10) is meaningless.
BARRENO_FUNCTION bool sound_increment(const Increment& i, const Sym3& stress) {
  constexpr double largest_increment = 10.0;
  const double strain_squared = contract(i.strain, i.strain);
  return strain_squared <= largest_increment * largest_increment &&
         std::isfinite(contract(stress, stress)) &&
         std::isfinite(i.volume_ratio_begin + i.volume_ratio_end);
}

/// Part of the way from one evp to the other at which the moduli jump; 1 if it does not lie
/// between.
BARRENO_FUNCTION double way_to_jump(const Elasticity& e, double evp_begin, double evp_end) {
  return e.crosses_jump(evp_begin, evp_end) ? evp_begin / (evp_begin - evp_end) : 1.0;
}

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
  PressureTermOf<double> term{};  ///< pressure dependence at the start
  double coupling = 0.0;          ///< elastic-plastic coupling at the start [stress]
  double evp = 0.0;               ///< plastic strain the moduli were taken at
  BARRENO_FUNCTION double q() const { return std::sqrt(J2); }
};

/// What is known of the error of an attempt at a substep.
struct Attempt {
  double error = 0.0;    ///< estimated local error [stress]
  double allowed = 0.0;  ///< what it may be [stress]
  int order = 2;         ///< power of the step size in `error`
};

/// Factor for the next substep, in sixteenths: then round-off does not reach the choice of
/// substeps, and both solvers, or two machines, take the same ones.
BARRENO_FUNCTION double step_factor(const Attempt& a) {
  constexpr double safety = 0.9, smallest = 0.125, largest = 4.0, grain = 16.0;
  if (a.error <= 0.0) return largest;
  const double ratio = a.allowed / a.error;
  const double factor = safety * (a.order == 3 ? std::cbrt(ratio) : std::sqrt(ratio));
  return smaller(larger(std::floor(grain * factor) / grain, smallest), largest);
}

/// Result of one attempt at a substep.
struct ScalarAttempt : Attempt {
  PointState end{};
  double elastic_work = 0.0, plastic_work = 0.0;  ///< per current volume [stress]
  Moduli moduli{};                                ///< tangent moduli at the end
};

BARRENO_FUNCTION double allowed_error(
    const Rock& rock, const PointState& n, double x_end, double q_end
) {
  const double start = size_of_stress(n.x, second_invariant(n.s));
  const double end = size_of_stress(x_end, q_end * q_end);
  return rock.tolerance * larger(larger(start, end), rock.stress_floor);
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
