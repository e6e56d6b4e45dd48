// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The point update of Arenisca for several points at once (real.hpp). Read first: arenisca.hpp, which
// includes this, and arenisca/substep.hpp, which is the same for one point.
#include "barreno/arenisca/points_step.hpp"
#include "barreno/models/arenisca.hpp"

namespace barreno {
namespace arenisca {

/// NaN, infinite or absurd input, see Arenisca::sound_input().
template <class R>
BARRENO_FUNCTION MaskOf<R> sound_points(
    const IncrementOf<Sym3Of<R>>& i, const Sym3Of<R>& stress, const R& evp, const R& shear_strain
) {
  constexpr double largest_increment = 10.0;
  const R sum = contract(stress, stress) + evp + shear_strain + i.volume_ratio_begin +
                i.volume_ratio_end;
  return (contract(i.strain, i.strain) <= largest_increment * largest_increment) &
         real::is_finite(sum);
}

/// Elastic prediction of whole steps.
template <class R>
struct WholeStepOf {
  MaskOf<R> inside;
  R x;
  Sym3Of<R> s;
  ModuliOf<R> used;
};
/// Start of a step in invariants.
template <class R>
struct StartOf {
  R x;
  Sym3Of<R> s;
  R evp;
  R dv;
  Sym3Of<R> de;
  PressureTermOf<R> term{};
  R coupling{};
  ModuliOf<R> moduli{};
};

template <class R>
BARRENO_FUNCTION WholeStepOf<R> predict_whole_step(
    const Rock& rock, const StartOf<R>& n, const CapOf<R>& cap, const MaskOf<R>& asked
) {
  WholeStepOf<R> p;
  p.used = used_moduli(rock, n.x, R(3.0 * n.dv), cap, n.term, n.coupling, n.moduli);
  p.x = n.x + 3.0 * p.used.bulk * n.dv;
  p.s = n.s + R(2.0 * p.used.shear) * n.de;
  p.inside = contains(rock.surface, asked, p.x, R(0.5 * contract(p.s, p.s)), cap);
  return p;
}

/// Whole steps that are elastic with moduli that hardly change: step_elastically(), and the first
/// substep of integrate() where the virgin cap does not decide.
/// @param[out] outcome of those
/// @return where it is so
template <class R>
BARRENO_FUNCTION MaskOf<R> step_elastically(
    const Rock& rock,
    const StartOf<R>& n,
    const MaskOf<R>& asked,
    WholeStepOf<R>& p,
    PointsOutcome<R>& outcome
) {
  // Inside the virgin rock's surface is inside that of compacted rock: no logarithm is needed.
  p = predict_whole_step(
      rock, n, same_cap<R>(rock.first_cap), MaskOf<R>(asked & (n.evp <= 0.0))
  );
  const MaskOf<R> open = asked & !p.inside;
  if (real::any(open)) {
    const WholeStepOf<R> own = predict_whole_step(rock, n, cap_of(rock, n.evp), open);
    p.x = real::select(open, own.x, p.x);
    p.s = select_points<R>(open, own.s, p.s);
    p.used = {
        real::select(open, own.used.bulk, p.used.bulk),
        real::select(open, own.used.shear, p.used.shear)};
    p.inside = p.inside | own.inside;
  }
  const ModuliOf<R> end =
      moduli_after_points(rock, p.inside, n.x, n.evp, p.x, n.term, n.coupling);
  outcome.elastic_work =
      0.5 * ((n.x + p.x) * (n.dv * (1.0 / 3.0)) + contract(n.s + p.s, n.de));
  outcome.plastic_work = R{};
  outcome.longitudinal_modulus = end.bulk + (4.0 / 3.0) * end.shear;
  // |d sigma| <= 2 max(|sigma_n|, |sigma_n1|): no need to measure the stresses.
  return p.inside & (2.0 * mismatch_of(n.moduli, p.used, end) <= rock.tolerance);
}

/// Basis of the plane of stress deviator and strain increment: s + t * along is orthogonal to s.
template <class R>
struct PlaneOf {
  Sym3Of<R> s, across;  ///< the stress deviator, and the increment's part orthogonal to it
  R s_size, across_size;
  R along;  ///< the increment's part along s, as a multiple of s

  BARRENO_FUNCTION Sym3Of<R> tensor(const ShearOf<R>& t) const {
    return R(ratio(t.a, s_size)) * s + R(ratio(t.b, across_size)) * across;
  }
  BARRENO_FUNCTION static R ratio(const R& part, const R& whole) {
    return real::select(whole > 0.0, part / whole, 0.0);
  }
};
template <class R>
BARRENO_FUNCTION PlaneOf<R> plane_of(const Sym3Of<R>& s, const Sym3Of<R>& de) {
  PlaneOf<R> plane;
  const R squares = contract(s, s);
  plane.along = real::select(squares > 0.0, contract(s, de) / squares, 0.0);
  plane.s = s;
  plane.across = de - plane.along * s;
  plane.s_size = real::sqrt(R(0.5 * squares));
  plane.across_size = real::sqrt(R(0.5 * contract(plane.across, plane.across)));
  return plane;
}

/// Attempts at substeps before a point is left to the update of single points.
constexpr int most_attempts_together = 12;

/// integrate() for the points asked for, from their start.
template <class R>
BARRENO_FUNCTION StepOf<R> integrate_points(
    const Rock& rock,
    const StartOf<R>& n,
    const PlaneOf<R>& plane,
    const R& shear_strain,
    const MaskOf<R>& asked
) {
  constexpr double least_fraction = 1.0 / 1024.0, smallest_strain = 1e-5;
  StepOf<R> step;
  step.state = {n.x, ShearOf<R>{plane.s_size, R{}}, n.evp, shear_strain};
  step.cap = cap_of(rock, n.evp);
  step.dv = n.dv;
  step.de = {plane.along * plane.s_size, plane.across_size};
  const R size = size_of_stress(n.dv, squared(step.de));
  const MaskOf<R> large = size * least_fraction > smallest_strain;
  step.smallest = real::select(large, smallest_strain / size, least_fraction);
  step.active = asked;
  for (int i = 0; i < most_attempts_together && real::any(step.active); ++i)
    advance_step(rock, step);
  step.refused = step.refused | step.active;
  return step;
}

}  // namespace arenisca

/// update() for the points asked for, one after the other.
BARRENO_FUNCTION void update_one_by_one(
    const Arenisca& model,
    bool asked,
    const Increment& increment,
    Sym3& stress,
    Arenisca::History& history,
    PointsOutcome<double>& outcome
) {
  if (!asked) return;
  const Outcome one = model.update(increment, stress, history);
  outcome = {!one.failed(), one.elastic_work, one.plastic_work, one.longitudinal_modulus};
}

#if BARRENO_HAS_LANES
/// One lane of a structure that consists of reals, and back.
template <class One, class Several>
inline One lane_of(const Several& from, int lane) {
  static_assert(sizeof(Several) == lane_count * sizeof(One), "the same structure over reals");
  One to;
  for (std::size_t c = 0; c < sizeof(One) / sizeof(double); ++c)
    reinterpret_cast<double*>(&to)[c] = reinterpret_cast<const Lanes*>(&from)[c][lane];
  return to;
}
template <class One, class Several>
inline void set_lane(const One& from, int lane, Several& to) {
  static_assert(sizeof(Several) == lane_count * sizeof(One), "the same structure over reals");
  for (std::size_t c = 0; c < sizeof(One) / sizeof(double); ++c)
    reinterpret_cast<Lanes*>(&to)[c][lane] = reinterpret_cast<const double*>(&from)[c];
}

inline void update_one_by_one(
    const Arenisca& model,
    const LaneMask& asked,
    const IncrementOf<Sym3Of<Lanes>>& increment,
    Sym3Of<Lanes>& stress,
    Arenisca::HistoryOf<Lanes>& history,
    PointsOutcome<Lanes>& outcome
) {
  for (int i = 0; i < lane_count; ++i) {
    if (asked[i] == 0) continue;
    Increment of_one;
    of_one.strain = lane_of<Sym3>(increment.strain, i);
    of_one.dt = increment.dt;
    of_one.volume_ratio_begin = increment.volume_ratio_begin[i];
    of_one.volume_ratio_end = increment.volume_ratio_end[i];
    of_one.viscous_pressure = increment.viscous_pressure[i];
    auto stress_of_one = lane_of<Sym3>(stress, i);
    auto history_of_one = lane_of<Arenisca::History>(history, i);
    const Outcome one = model.update(of_one, stress_of_one, history_of_one);
    set_lane(stress_of_one, i, stress);
    set_lane(history_of_one, i, history);
    outcome.sound[i] = one.failed() ? 0 : -1;
    outcome.elastic_work[i] = one.elastic_work;
    outcome.plastic_work[i] = one.plastic_work;
    outcome.longitudinal_modulus[i] = one.longitudinal_modulus;
  }
}
#endif

template <class R>
BARRENO_FUNCTION PointsOutcome<R> Arenisca::update_points(
    const IncrementOf<Sym3Of<R>>& increment, Sym3Of<R>& stress, HistoryOf<R>& history
) const {
  using namespace arenisca;
  PointsOutcome<R> outcome{};
  const MaskOf<R> asked = sound_points(
      increment, stress, history.plastic_volume_strain, history.equivalent_plastic_strain
  );
  outcome.sound = asked;
  if (rock_.bisection) {
    update_one_by_one(*this, asked, increment, stress, history, outcome);
    return outcome;
  }
  StartOf<R> n{
      trace(stress),
      deviator(stress),
      history.plastic_volume_strain,
      trace(increment.strain),
      deviator(increment.strain)};
  n.term = pressure_term_of(rock_.elasticity, n.x, n.evp);
  n.coupling = coupling_of(rock_.elasticity, n.x, n.evp);
  n.moduli = moduli_of(rock_.elasticity, n.term.value, n.coupling);
  WholeStepOf<R> whole;
  const MaskOf<R> elastic = step_elastically(rock_, n, asked, whole, outcome);
  const MaskOf<R> flows = asked & !elastic;
  MaskOf<R> refused = flows;
  if (real::any(flows)) {
    const PlaneOf<R> plane = plane_of(n.s, n.de);
    const StepOf<R> step =
        integrate_points(rock_, n, plane, history.equivalent_plastic_strain, flows);
    whole.x = real::select(flows, step.state.x, whole.x);
    whole.s = select_points<R>(flows, plane.tensor(step.state.s), whole.s);
    outcome.elastic_work = real::select(flows, step.elastic_work, outcome.elastic_work);
    outcome.plastic_work = real::select(flows, step.plastic_work, outcome.plastic_work);
    outcome.longitudinal_modulus =
        real::select(flows, step.modulus, outcome.longitudinal_modulus);
    refused = step.refused;
    const MaskOf<R> kept = flows & !refused;
    history.plastic_volume_strain =
        real::select(kept, step.state.evp, history.plastic_volume_strain);
    history.equivalent_plastic_strain =
        real::select(kept, step.state.shear_strain, history.equivalent_plastic_strain);
  }
  const R mean_ratio = 0.5 * (increment.volume_ratio_begin + increment.volume_ratio_end);
  outcome.elastic_work = mean_ratio * outcome.elastic_work;
  outcome.plastic_work = mean_ratio * outcome.plastic_work;
  const Sym3Of<R> end = whole.s + isotropic(R(whole.x * (1.0 / 3.0)));
  stress = select_points<R>(asked & !refused, end, stress);
  if (real::any(refused)) update_one_by_one(*this, refused, increment, stress, history, outcome);
  return outcome;
}

}  // namespace barreno
