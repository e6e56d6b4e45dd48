// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/tension.hpp"
#include "barreno/arenisca/points_damage.hpp"
#include "barreno/arenisca/points_pores.hpp"
#include "barreno/arenisca/points_rate.hpp"
#include "barreno/arenisca/points_start.hpp"

namespace barreno::arenisca {

// The bound on principal tension (parts/tension.hpp) of one or several points, at the end of a
// step.

/// One rotation of Jacobi's method, which ends the component pq.
/// @param a  the tensor, upper half
template <class R>
BARRENO_FUNCTION void rotate(R (&a)[3][3], R (&axis)[3][3], int p, int q) {
  const int r = 3 - p - q;
  const R off = a[p][q], difference = a[q][q] - a[p][p];
  const R root = real::sqrt(R(difference * difference + 4.0 * off * off));
  const R below = real::abs(difference) + root;
  const R part = 2.0 * off / real::select(below > 0.0, below, 1.0);
  const R tangent = real::select(difference < 0.0, -part, part);
  const R cosine = 1.0 / real::sqrt(R(1.0 + tangent * tangent));
  const R sine = tangent * cosine;
  a[p][p] = a[p][p] - tangent * off;
  a[q][q] = a[q][q] + tangent * off;
  a[p][q] = R{};
  R& rp = r < p ? a[r][p] : a[p][r];
  R& rq = r < q ? a[r][q] : a[q][r];
  const R first = rp;
  rp = cosine * first - sine * rq;
  rq = sine * first + cosine * rq;
  for (int i = 0; i < 3; ++i) {
    const R along = axis[p][i];
    axis[p][i] = cosine * along - sine * axis[q][i];
    axis[q][i] = sine * along + cosine * axis[q][i];
  }
}

/// By Jacobi's cyclic method, which knows no equal values that are harder than others. Components
/// that are nothing beside the rest count as zero: a tensor that is done stays as it is, whatever
/// the others need.
/// @param asked  zero is returned elsewhere
template <class R>
BARRENO_FUNCTION PrincipalOf<R> principal_of(const MaskOf<R>& asked, const Sym3Of<R>& s) {
  constexpr int most_sweeps = 8;
  constexpr double nothing = 1e-17;
  const R zero{}, one = zero + 1.0;
  const auto of = [&](const R& c) { return R(real::select(asked, c, zero)); };
  R a[3][3] = {{of(s.xx), of(s.xy), of(s.zx)}, {zero, of(s.yy), of(s.yz)}, {zero, zero, of(s.zz)}};
  PrincipalOf<R> out{{}, {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
  const R least = nothing * real::sqrt(R(contract(s, s)));
  const auto drop = [&](R& c) { c = real::select(real::abs(c) > least, c, 0.0); };
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    drop(a[0][1]), drop(a[0][2]), drop(a[1][2]);
    if (!real::any((a[0][1] != 0.0) | (a[0][2] != 0.0) | (a[1][2] != 0.0))) break;
    // In two dimensions only the first is there.
    if (real::any(a[0][1] != 0.0)) rotate(a, out.axis, 0, 1);
    if (real::any(a[0][2] != 0.0)) rotate(a, out.axis, 0, 2);
    if (real::any(a[1][2] != 0.0)) rotate(a, out.axis, 1, 2);
  }
  for (int k = 0; k < 3; ++k) out.value[k] = a[k][k];
  return out;
}

/// The largest of three first.
template <class R>
BARRENO_FUNCTION void sort_falling(R (&t)[3]) {
  const auto order = [](R& a, R& b) {
    const R larger = larger_of(a, b), smaller = smaller_of(a, b);
    a = larger;
    b = smaller;
  };
  order(t[0], t[1]);
  order(t[1], t[2]);
  order(t[0], t[1]);
}

/// Damage at the end of an opening that it lowers the bound of:
///
///   D = D_0 + share (damaging strain of the opening at the bound (1 - D) T)/e_f,   D <= 1
///
/// The right side rises with D, by less than D does unless e_f is below the elastic strain at the
/// peak. Where it does not reach D = 1 the secant finds the root, and halving where that leaves the
/// bracket. The right side at D_0 is near the root: e_f is far above that strain as a rule.
/// @param whole  bound of rock without damage [stress]
/// @param begin  D_0
/// @param share_per_strain  share/e_f
template <class R>
BARRENO_FUNCTION R damage_of_opening(
    const MaskOf<R>& asked,
    const CracksOf<R>& cracks,
    const R& whole,
    const R& begin,
    const R& share_per_strain
) {
  constexpr int most = 100;
  constexpr double nothing = 1e-15;
  const auto missing = [&](const R& damage) {
    const OpeningOf<R> o = cracks.opening(R((1.0 - damage) * whole));
    return R((begin - damage) + share_per_strain * damaging_strain(o.squares(), o.sum));
  };
  R low = begin, high = R{} + 1.0, before = begin, at_before = missing(begin);
  const MaskOf<R> breaks = missing(high) >= 0.0;
  R damage = real::select(breaks, high, begin);
  MaskOf<R> open = asked & !breaks & (at_before > nothing);
  R guess = real::smaller(R(begin + at_before), 1.0);
  for (int i = 0; i < most && real::any(open); ++i) {
    const R at = missing(guess);
    damage = real::select(open, guess, damage);
    low = real::select(at > 0.0, guess, low);
    high = real::select(at > 0.0, high, guess);
    open = open & (real::abs(at) > nothing) & (high - low > nothing);
    const R fall = real::select(at != at_before, at_before - at, 1.0);
    const R next = guess + at * ((guess - before) / fall);
    before = guess;
    at_before = at;
    guess = real::select((next > low) & (next < high), next, 0.5 * (low + high));
  }
  return damage;
}

/// A state that cracks open in, and what they make of it.
template <class R>
struct CutOf {
  R coherence, fracture_strain;
  R taken = R{} + 1.0;  ///< share of the plastic strain that damages
  R damage, x;
  Sym3Of<R> s;
  R evp, shear_strain, elastic_work, plastic_work;
  PoresOf<R> pores{};
  Sym3Of<R> missed{};  ///< change of the effective stress had the step been elastic, less what it
                       ///< was
};

/// Cracks that a state opens.
template <class R>
struct FoundOf {
  MaskOf<R> torn;
  ModuliOf<R> moduli;  ///< of the skeleton
  R bulk;              ///< as the opening sees it: the fluid's pressure falls with it
  Sym3Of<R> strain;
  R sum, sheared, damage, work;
};

/// Strain tensor of an opening.
template <class R>
BARRENO_FUNCTION Sym3Of<R> strain_of(
    const PrincipalOf<R>& principal, const CracksOf<R>& cracks, const R& bound, const R& sum
) {
  Sym3Of<R> strain{};
  const R least = bound + cracks.lambda * sum;
  for (int k = 0; k < 3; ++k) {
    const R(&v)[3] = principal.axis[k];
    const R part = real::larger(R(principal.value[k] - least), 0.0) / cracks.twice_shear;
    const Sym3Of<R> square = {
        v[0] * v[0], v[1] * v[1], v[2] * v[2], v[0] * v[1], v[1] * v[2], v[2] * v[0]};
    strain = strain + part * square;
  }
  return strain;
}

/// Cracks where a principal effective stress exceeds its bound.
template <class R, class Law>
BARRENO_ALIKE FoundOf<R> find_cracks(const Law& law, const MaskOf<R>& asked, const CutOf<R>& c) {
  FoundOf<R> f{};
  const R whole = law.tension.cutoff * c.coherence;
  PrincipalOf<R> principal = principal_of(asked, c.s);
  f.moduli = law.elasticity.moduli_at(c.x, c.evp);
  press_moduli(law, c, c.x, f.moduli);
  f.bulk = f.moduli.bulk;
  if constexpr (has_poroplastic_fluid<Law>) {
    const Constituents& k = law.constituents;
    const R per_matrix = compliances_at(k, c.pores, c.x).whole;
    f.bulk = f.bulk * (1.0 + per_matrix * fall_of(k, c.pores, c.x, f.bulk));
  }
  CracksOf<R> cracks;
  cracks.twice_shear = 2.0 * f.moduli.shear;
  cracks.lambda = f.bulk - (1.0 / 3.0) * cracks.twice_shear;
  for (int k = 0; k < 3; ++k) {
    principal.value[k] = principal.value[k] + c.x * (1.0 / 3.0);
    cracks.stress[k] = principal.value[k];
  }
  sort_falling(cracks.stress);
  const R bound = (1.0 - c.damage) * whole;
  // A state that cracks have left is at the bound but for round-off.
  constexpr double nothing = 1e-13;
  const R size = real::abs(cracks.stress[0]) + real::abs(cracks.stress[2]);
  f.torn = asked & (cracks.stress[0] > bound + nothing * size);
  if (!real::any(f.torn)) return f;
  f.damage = damage_of_opening(f.torn, cracks, whole, c.damage, R(c.taken / c.fracture_strain));
  const R lower = (1.0 - f.damage) * whole;
  const OpeningOf<R> o = cracks.opening(lower);
  f.strain = strain_of(principal, cracks, lower, o.sum);
  f.sum = o.sum;
  f.sheared = real::sqrt(R((4.0 / 3.0) * o.squares()));
  f.work = 0.5 * (bound + lower) * o.sum;
  return f;
}

/// What an opening adds to histories and works, but for the work that its strain takes.
template <class R>
BARRENO_FUNCTION void count_opening(const FoundOf<R>& f, CutOf<R>& c) {
  c.damage = real::select(f.torn, f.damage, c.damage);
  c.evp = real::select(f.torn, c.evp + f.sum, c.evp);
  c.shear_strain = real::select(f.torn, c.shear_strain + f.sheared, c.shear_strain);
  c.elastic_work = real::select(f.torn, c.elastic_work - f.work, c.elastic_work);
  c.plastic_work = real::select(f.torn, c.plastic_work + f.work, c.plastic_work);
}

/// Pores that an opening has widened.
/// @return rise of their pressure [stress]
template <class R>
BARRENO_FUNCTION R
take_pores(const MaskOf<R>& torn, const FilledOf<R>& widened, PoresOf<R>& pores) {
  const R before = pores.pressure;
  assign_where(torn, widened.end, pores);
  return pores.pressure - before;
}

/// Pores that cracks widen before the skeleton strains: of that only the grains change, by the
/// pressure of the fluid.
/// @param x           I1 of the effective stress [stress]
/// @param per_matrix  1/Km there [1/stress]
/// @param sum         opening
template <class R>
BARRENO_FUNCTION FilledOf<R> fill_cracks(
    const Constituents& c,
    const PoresOf<R>& n,
    const R& x,
    const R& per_matrix,
    const R& bulk,
    const R& sum
) {
  const R guess = with_compliances(c, n, x, [&](const auto& k) {
    return R(R{} - sum / storage_of(k, n, bulk));
  });
  if (!c.change) return fill_pores(c, n, elastic_grains(c, n, bulk, R{}), sum, guess);
  const ChangingGrainsOf<R> grains(c, n, x, R(x * (-1.0 / 3.0)), R(bulk * per_matrix));
  return fill_changing_pores(c, n, grains, sum, guess);
}

/// Takes an opening from the state at the end of a step, at fixed strain.
/// @param dv, de  strain of the step that the law has seen
template <class R, class Law>
BARRENO_FUNCTION void take_opening(
    const Law& law, const FoundOf<R>& f, const R& dv, const Sym3Of<R>& de, CutOf<R>& c
) {
  constexpr double third = 1.0 / 3.0;
  const R fall = 3.0 * f.bulk * f.sum;
  const Sym3Of<R> shear = R(2.0 * f.moduli.shear) * (f.strain - isotropic(R(third * f.sum)));
  R missed = fall, fall_of_I1 = fall;
  if constexpr (has_poroplastic_fluid<Law>) {
    const Constituents& k = law.constituents;
    const R guess = R{} - fall_of(k, c.pores, c.x, f.moduli.bulk) * f.sum;
    const R x_end = c.x - fall, before = c.pores.pressure;
    const R rise =
        take_pores(f.torn, fill_loaded_pores(k, c.pores, c.x, x_end, R{}, guess), c.pores);
    const R per_matrix = per_matrix_between(k, R(before + c.pores.pressure), R(c.x + x_end));
    missed = fall + R(3.0 * per_matrix) * f.moduli.bulk * rise;
    fall_of_I1 = fall + 3.0 * rise;
  }
  const R work = 0.5 * (fall_of_I1 * (third * dv) + contract(shear, de));
  c.elastic_work = real::select(f.torn, c.elastic_work - work, c.elastic_work);
  c.x = real::select(f.torn, c.x - fall, c.x);
  assign_where(f.torn, c.s - shear, c.s);
  assign_where(f.torn, c.missed + shear + isotropic(R(third * missed)), c.missed);
  count_opening(f, c);
}

/// Bound on the principal effective stresses [stress].
template <class R, class Law>
BARRENO_FUNCTION R tension_bound(const Law& law, const R& damage, const R& coherence) {
  return (1.0 - damage) * (law.tension.cutoff * coherence);
}
/// Where a principal effective stress may exceed its bound: at few points, which need more.
template <class R, class Law>
BARRENO_FUNCTION MaskOf<R> near_bound(
    const Law& law, const MaskOf<R>& asked, const R& bound, const R& x, const Sym3Of<R>& s
) {
  constexpr double negligible = 1e-30;
  const R room = bound - x * (1.0 / 3.0);
  const R J2 = 0.5 * contract(s, s);
  const double nothing = negligible * law.stress_floor;
  const MaskOf<R> some = asked & (room * room + J2 > nothing * nothing);
  const auto J3 = [&] {
    return R(
        s.xx * (s.yy * s.zz - s.yz * s.yz) - s.xy * (s.xy * s.zz - s.yz * s.zx) +
        s.zx * (s.xy * s.yz - s.yy * s.zx)
    );
  };
  return Tension::may_exceed(some, room, J2, J3);
}

/// What the bound on tension reads of points.
/// @param holder of their coherence and damage: a history or a step
template <class R, class Holder>
BARRENO_FUNCTION CutOf<R> cut_of(const Holder& holder) {
  CutOf<R> c{};
  c.coherence = holder.coherence;
  c.fracture_strain = holder.fracture_strain;
  c.damage = holder.damage;
  return c;
}

/// Opening of steps as if they were elastic: the law is given what it leaves of the strain. Where
/// bound and surface hold together most of the strain opens cracks. A surface that is asked first
/// would take that strain for flow that dilates, and press the sides.
/// @param[in,out] n  start
/// @param[in,out] c  what histories tell; damage, shear strain, works and what elastic steps miss
/// @return where cracks open
template <class R, class Law>
BARRENO_FUNCTION MaskOf<R> open_before(
    const RockOf<R, Law>& rock,
    const Law& law,
    const MaskOf<R>& flows,
    StartOf<R, Law>& n,
    CutOf<R>& c
) {
  constexpr double third = 1.0 / 3.0;
  const ModuliOf<R>& m = n.elastic.moduli;
  c.x = n.x + 3.0 * m.bulk * skeleton_guess<R>(rock, n, n.x, m.bulk);
  c.s = n.s + R(2.0 * m.shear) * n.de;
  c.evp = n.evp;
  const R bound = tension_bound(law, c.damage, c.coherence);
  const MaskOf<R> near = near_bound(law, flows, bound, c.x, c.s);
  if (!real::any(near)) return near;
  if constexpr (Law::wet) c.pores = n.pores;
  const FoundOf<R> f = find_cracks(law, near, c);
  if (!real::any(f.torn)) return f.torn;
  if constexpr (has_poroplastic_fluid<Law>) {
    // The cracks fill first.
    const Constituents& k = law.constituents;
    const R per_matrix = compliances_at(k, n.pores, n.x).whole;
    const FilledOf<R> widened = fill_cracks(k, n.pores, n.x, per_matrix, m.bulk, f.sum);
    const R rise = take_pores(f.torn, widened, n.pores);
    n.x = n.x + R(3.0 * per_matrix) * m.bulk * rise;
  }
  const Sym3Of<R> shear = f.strain - isotropic(R(third * f.sum));
  const Sym3Of<R> missed = R(2.0 * f.moduli.shear) * shear + isotropic(R(f.moduli.bulk * f.sum));
  n.dv = real::select(f.torn, n.dv - f.sum, n.dv);
  assign_where(f.torn, n.de - shear, n.de);
  assign_where(f.torn, missed, c.missed);
  count_opening(f, c);
  n.evp = c.evp;
  ElasticStateOf<R> elastic = rock.elasticity.state_at(n.x, n.evp);
  press_moduli(rock, n, n.x, elastic.moduli);
  assign_where(f.torn, elastic, n.elastic);
  return f.torn;
}

/// The work of the strain of cracks that have opened before the law's own step: the mean stress at
/// the ends of the step times what the law has not been given [stress].
/// @param twice_mean  total stress before the step and after it
template <class R, class Law, class Points>
BARRENO_FUNCTION R
work_before(const Points& p, const StepOf<R, Law>& step, const Sym3Of<R>& twice_mean, const R& dv) {
  const Sym3Of<R> shear = deviator(p.increment.strain) - step.strain;
  return 0.5 * (trace(twice_mean) * ((1.0 / 3.0) * (dv - step.dv)) + contract(twice_mean, shear));
}

/// The bound on principal tension at the end of steps.
/// @param s       shear stress
/// @param begin   total quasi-static stress before the step
/// @param[in,out] step  all but its stress, which the bound turns out of its plane
/// @param[in,out] end   stress, pores and works
/// @return what the step misses of an elastic one by the bound [stress]
template <class R, class Law, class Points, class End>
BARRENO_FUNCTION Sym3Of<R> cut_step(
    const Law& law,
    const MaskOf<R>& good,
    const Points& p,
    const Sym3Of<R>& s,
    const Sym3Of<R>& begin,
    StepOf<R, Law>& step,
    End& end
) {
  R dv = trace(p.increment.strain);
  if constexpr (Law::heated) dv = dv - p.history.thermal_expansion;
  step.elastic_work = step.elastic_work + work_before(p, step, begin + end.stress, dv);
  end.elastic_work = step.elastic_work;
  const R bound = tension_bound(law, step.damage, step.coherence);
  const MaskOf<R> near = near_bound(law, good, bound, step.state.x, s);
  if (!real::any(near)) return {};
  CutOf<R> c = cut_of<R>(step);
  if constexpr (Law::rated) c.taken = step.taken;
  c.x = step.state.x;
  c.s = s;
  c.evp = step.state.evp;
  c.shear_strain = step.state.shear_strain;
  c.elastic_work = step.elastic_work;
  c.plastic_work = step.plastic_work;
  c.pores = end.pores;
  const FoundOf<R> f = find_cracks(law, near, c);
  if (!real::any(f.torn)) return {};
  take_opening(law, f, dv, deviator(p.increment.strain), c);
  step.damage = c.damage;
  step.state.x = c.x;
  step.state.evp = c.evp;
  step.state.shear_strain = c.shear_strain;
  step.elastic_work = end.elastic_work = c.elastic_work;
  step.plastic_work = end.plastic_work = c.plastic_work;
  if constexpr (Law::wet) step.pores = c.pores;
  end.pores = c.pores;
  assign_where(f.torn, c.s + isotropic(R(c.x * (1.0 / 3.0) - c.pores.pressure)), end.stress);
  return c.missed;
}

}  // namespace barreno::arenisca
