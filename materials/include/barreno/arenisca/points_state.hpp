// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points.hpp"

namespace barreno::arenisca {

// What substep.hpp and rock.hpp pass on between the parts of a substep, for one or several points.

/// PointState in the plane of the step.
template <class R>
struct StateOf {
  R x;
  ShearOf<R> s;
  R evp, shear_strain;
};

/// Substep, with what both passes read of its start.
template <class R>
struct SubstepOf {
  StateOf<R> n;
  CapOf<R> cap;
  R dv;
  ShearOf<R> de;
};

/// Prediction, its invariants and the surface straight below it.
template <class R>
struct PredictionOf {
  R x;
  ShearOf<R> s;
  R J2, q;
  ModuliOf<R> start, used;
  PressureTermOf<R> term;
  R coupling;
};

/// Attempt; `refused` where the point is left to the update of single points.
template <class R>
struct AttemptOf {
  StateOf<R> end;
  R error, allowed;
  MaskOf<R> elastic, refused;
  R elastic_work, plastic_work;
  ModuliOf<R> moduli;
};

template <class R>
BARRENO_FUNCTION void predict_with(
    const SubstepOf<R>& step, const ModuliOf<R>& used, PredictionOf<R>& p
) {
  p.used = used;
  p.x = step.n.x + 3.0 * used.bulk * step.dv;
  p.s = step.n.s + R(2.0 * used.shear) * step.de;
  p.J2 = squared(p.s);
  p.q = real::sqrt(p.J2);
}

/// Relative difference of the moduli used from the mean of both ends, see moduli_mismatch().
template <class R>
BARRENO_FUNCTION R
mismatch_of(const ModuliOf<R>& start, const ModuliOf<R>& used, const ModuliOf<R>& end) {
  const R bulk = real::abs(R(0.5 * (start.bulk + end.bulk) / used.bulk - 1.0));
  const R shear = real::abs(R(0.5 * (start.shear + end.shear) / used.shear - 1.0));
  return larger_of(bulk, shear);
}

template <class R>
BARRENO_FUNCTION R
allowed_error_of(const Rock& rock, const StateOf<R>& n, const R& x_end, const R& J2_end) {
  const R start = size_of_stress(n.x, squared(n.s)), end = size_of_stress(x_end, J2_end);
  return rock.tolerance * real::larger(larger_of(start, end), rock.stress_floor);
}

}  // namespace barreno::arenisca
