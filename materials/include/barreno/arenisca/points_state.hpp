// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points_angle.hpp"
#include "barreno/arenisca/points_damage.hpp"
#include "barreno/arenisca/points_heat.hpp"
#include "barreno/arenisca/points_pieces.hpp"
#include "barreno/arenisca/points_pores.hpp"

namespace barreno::arenisca {

// What the parts of a substep pass on to each other, for one or several points.

/// State of points between substeps: I1, shear stress (in the plane of the step if the law lets
/// it), volumetric and equivalent plastic strain.
template <class R, class Law>
struct StateOf {
  R x;
  ShearIn<R, Law> s;
  R evp, shear_strain;
};

/// What a substep starts from and the strain increment that it is asked, in volume and deviator.
template <class R, class Law>
struct SubstepOf : WithPores<R, Law::wet> {
  StateOf<R, Law> n;
  CapOf<R> cap;
  R dv;
  ShearIn<R, Law> de;
};

/// How the pressure of the fluid follows a prediction: rise - fall d(evp).
template <class R, bool wet>
struct PressurePath {};
template <class R>
struct PressurePath<R, true> {
  R rise{}, fall{};
  R per_matrix{};                     ///< 1/Km on the way [1/stress]
  PoresOf<R> elastic;                 ///< pores at the prediction
  MaskOf<R> unsolved = none_of<R>();  ///< where no pressure was found
};

/// Elastic prediction of a substep, and the moduli at its start and as used.
template <class R, class Law>
struct PredictionOf : PressurePath<R, Law::wet>, WithAngle<R, Law::angled> {
  R x;
  ShearIn<R, Law> s;
  R J2, q;
  ModuliOf<R> start, used;
  ElasticStateOf<R> begin;  ///< of the substep
  R evp;                    ///< plastic strain that the moduli were taken at
};

/// What an attempt tells besides of rock with overstress: the moduli that an elastic substep would
/// have had.
template <class R, bool rated>
struct WithUsedModuli {};
template <class R>
struct WithUsedModuli<R, true> {
  ModuliOf<R> used;
};

/// Result of one attempt at a substep: its end, the estimated local error and what that may be
/// [stress], works per current volume, tangent moduli; `refused` where it asks for a shorter
/// substep.
template <class R, class Law>
struct AttemptOf : WithPores<R, Law::wet>,
                   WithUsedModuli<R, Law::rated>,
                   WithBreaking<R, Law::damaged> {
  StateOf<R, Law> end;
  R error, allowed;
  MaskOf<R> elastic, refused;
  R elastic_work, plastic_work;
  ModuliOf<R> moduli;
};

/// Volume strain of the skeleton in an elastic substep.
template <class R, class Law>
BARRENO_FUNCTION R skeleton_strain(const SubstepOf<R, Law>& step, const PredictionOf<R, Law>& p) {
  if constexpr (has_poroplastic_fluid<Law>)
    return step.dv + p.rise * p.per_matrix;
  else
    return step.dv;
}

/// Stress from moduli of the skeleton, and where the fluid is, from how its pressure rises.
template <class R, class Law>
BARRENO_FUNCTION void predict_with(
    const SubstepOf<R, Law>& step, const ModuliOf<R>& used, PredictionOf<R, Law>& p
) {
  p.used = used;
  p.x = step.n.x + 3.0 * used.bulk * skeleton_strain(step, p);
  p.s = step.n.s + R(2.0 * used.shear) * step.de;
  p.J2 = squared(p.s);
  p.q = real::sqrt(p.J2);
}
/// The angle of a prediction, where the law asks for it.
/// @param s  its shear stress, or another one that a return starts from
template <class R, class Law>
BARRENO_FUNCTION void find_angle(
    const RockOf<R, Law>& rock, const ShearIn<R, Law>& s, PredictionOf<R, Law>& p
) {
  if constexpr (Law::angled) p.angle = angle_of(rock.lode, s);
}

/// J2 of a prediction as the meridian of triaxial compression sees it.
template <class R, class Law>
BARRENO_FUNCTION R scaled_J2(const PredictionOf<R, Law>& p) {
  if constexpr (Law::angled)
    return p.J2 / (p.angle.gamma * p.angle.gamma);
  else
    return p.J2;
}

/// Path of the fluid's pressure in an elastic substep with this bulk modulus of the skeleton, and
/// p.per_matrix.
template <class R, class Law>
BARRENO_FUNCTION void predict_pressure(
    const RockOf<R, Law>& rock,
    const SubstepOf<R, Law>& step,
    const R& bulk,
    PredictionOf<R, Law>& p
) {
  if constexpr (Law::wet) p.elastic = step.pores;
  if constexpr (has_poroplastic_fluid<Law>) {
    const Constituents& c = rock.constituents;
    const PoresOf<R>& n = step.pores;
    const R biot = 1.0 - bulk * p.per_matrix;
    const R guess = with_compliances(c, n, step.n.x, [&](const auto& k) {
      return R(-biot * step.dv / storage_of(k, n, bulk));
    });
    const FilledOf<R> f = fill_elastic_pores(c, n, step.n.x, p.per_matrix, bulk, step.dv, guess);
    p.rise = f.rise;
    p.elastic = f.end;
    p.unsolved = f.unsolved;
    const R x_end = step.n.x + 3.0 * bulk * (step.dv + f.rise * p.per_matrix);
    p.fall = fall_of(c, f.end, x_end, bulk);
  }
}

/// 3K of the skeleton, as seen by a return: what plastic strain takes off the fluid's pressure
/// strains it too.
template <class R, class Law>
BARRENO_FUNCTION R stiffness_of_return(const PredictionOf<R, Law>& p) {
  if constexpr (has_poroplastic_fluid<Law>)
    return 3.0 * p.used.bulk * (1.0 + p.fall * p.per_matrix);
  else
    return 3.0 * p.used.bulk;
}

/// Error of the stress from where the fluid's pressure left its path: the skeleton was strained by
/// another one.
template <class R, class Law>
BARRENO_FUNCTION R pressure_error(
    const RockOf<R, Law>& rock,
    const SubstepOf<R, Law>& step,
    const PredictionOf<R, Law>& p,
    const AttemptOf<R, Law>& a
) {
  const R rise = p.rise - p.fall * (a.end.evp - step.n.evp);
  const R missed = a.pores.pressure - step.pores.pressure - rise;
  constexpr double per_root_3 = 0.57735026918962576;
  const R of_pressure = (3.0 * per_root_3) * p.per_matrix * p.used.bulk * real::abs(missed);
  const Constituents& c = rock.constituents;
  if (!c.change) return of_pressure;
  return of_pressure +
         error_of_grains(c, step.pores, step.n.x, a.pores, a.end.x, p.per_matrix, p.used.bulk);
}

/// The path of the fluid's pressure for a second pass: through the end of the first.
template <class R, class Law>
BARRENO_FUNCTION void follow_pressure(
    const RockOf<R, Law>& rock,
    const SubstepOf<R, Law>& step,
    const R& bulk,
    const AttemptOf<R, Law>& a,
    PredictionOf<R, Law>& p
) {
  if constexpr (has_poroplastic_fluid<Law>) {
    const Constituents& c = rock.constituents;
    p.fall = fall_of(c, a.pores, a.end.x, bulk);
    const R pressures = step.pores.pressure + a.pores.pressure;
    p.per_matrix = per_matrix_between(c, pressures, R(step.n.x + a.end.x));
    p.rise = a.pores.pressure - step.pores.pressure + p.fall * (a.end.evp - step.n.evp);
  }
}

/// The flow rule's metric, K as the return sees it.
template <class R, class Law>
BARRENO_FUNCTION R metric_of(
    const RockOf<R, Law>& rock, const SubstepOf<R, Law>& step, const PredictionOf<R, Law>& p
) {
  R metric{};
  if constexpr (Law::damaged)
    metric = rock.flow.metric(p.used, step.n.x, step.n.evp, step.cap, rock.intact);
  else
    metric = rock.flow.metric(p.used, step.n.x, step.n.evp, step.cap);
  if constexpr (has_poroplastic_fluid<Law>)
    return metric * (1.0 + p.fall * p.per_matrix);
  else
    return metric;
}

/// Work of the total stress over a substep, per current volume [stress].
template <class R, class Law>
BARRENO_FUNCTION R work_of_stress(const SubstepOf<R, Law>& step, const AttemptOf<R, Law>& a) {
  const R pressures = step.pores.pressure + a.pores.pressure;
  const R mean_I1 = 0.5 * (step.n.x + a.end.x) - 1.5 * pressures;
  return mean_I1 * (step.dv * (1.0 / 3.0)) + dot(step.n.s + a.end.s, step.de);
}

/// How far the moduli used are from the mean of those at both ends, relative.
template <class R>
BARRENO_FUNCTION R
mismatch_of(const ModuliOf<R>& start, const ModuliOf<R>& used, const ModuliOf<R>& end) {
  const R bulk = real::abs(R(0.5 * (start.bulk + end.bulk) / used.bulk - 1.0));
  const R shear = real::abs(R(0.5 * (start.shear + end.shear) / used.shear - 1.0));
  return larger_of(bulk, shear);
}

/// The attempt of other points into those of `choice`.
template <class R, class Law>
BARRENO_FUNCTION void select_attempt(
    const MaskOf<R>& choice, const AttemptOf<R, Law>& other, AttemptOf<R, Law>& a
) {
  assign_where(choice, other.end, a.end);
  assign_where(choice, other.error, a.error);
  assign_where(choice, other.allowed, a.allowed);
  assign_where(choice, other.refused, a.refused);
  assign_where(choice, other.elastic_work, a.elastic_work);
  assign_where(choice, other.plastic_work, a.plastic_work);
  assign_where(choice, other.moduli, a.moduli);
  assign_pores<Law>(choice, other, a);
  assign_breaking<Law>(choice, other, a);
  if constexpr (Law::rated) assign_where(choice, other.used, a.used);
}

template <class R, class Law>
BARRENO_FUNCTION R allowed_error_of(
    const RockOf<R, Law>& rock, const StateOf<R, Law>& n, const R& x_end, const R& J2_end
) {
  const R start = size_of_stress(n.x, squared(n.s)), end = size_of_stress(x_end, J2_end);
  return rock.tolerance * real::larger(larger_of(start, end), rock.stress_floor);
}

}  // namespace barreno::arenisca
