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
    rotate(a, out.axis, 0, 1);
    rotate(a, out.axis, 0, 2);
    rotate(a, out.axis, 1, 2);
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
/// peak; where it does not reach D = 1 the root is found by the Illinois method.
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
  R low = begin, high = R{} + 1.0, at_low = missing(low), at_high = missing(high);
  R damage = real::select(at_high >= 0.0, high, low);
  MaskOf<R> open = asked & (at_high < 0.0) & (at_low > nothing);
  R last{};  // side that moved last
  for (int i = 0; i < most && real::any(open); ++i) {
    const R slope = real::select(open, at_low - at_high, 1.0);
    const R guess = smaller_of(larger_of(R(low + (high - low) * (at_low / slope)), low), high);
    const R at = missing(guess);
    const MaskOf<R> rises = at > 0.0;
    damage = real::select(open, guess, damage);
    low = real::select(rises, guess, low);
    high = real::select(rises, high, guess);
    const MaskOf<R> again_low = rises & (last > 0.0), again_high = (!rises) & (last < 0.0);
    at_high = real::select(rises, real::select(again_low, 0.5 * at_high, at_high), at);
    at_low = real::select(rises, at, real::select(again_high, 0.5 * at_low, at_low));
    last = real::select(rises, R{} + 1.0, R{} - 1.0);
    open = open & (real::abs(at) > nothing) & (high - low > nothing);
  }
  return damage;
}

/// End of a step as the limit surface leaves it, and as the bound does.
template <class R>
struct CutOf {
  // Of the step.
  R dv;  ///< strain that the law has seen
  Sym3Of<R> de;
  R coherence, fracture_strain, damage;
  R taken = R{} + 1.0;  ///< share of the plastic strain that damages
  // Changed.
  R x;
  Sym3Of<R> s;
  R evp, shear_strain;
  R elastic_work, plastic_work;
  PoresOf<R> pores{};
  Sym3Of<R> missed{};  ///< change of the effective stress had the step been elastic, less what it
                       ///< was
};

/// Fluid in the pores that an opening at fixed strain widens.
/// @param rise_of_I1  of the effective stress [stress]
/// @param guess       of the rise of the pressure [stress]
template <class R, class Law>
BARRENO_FUNCTION void widen_pores(
    const Law& law, const MaskOf<R>& torn, const R& rise_of_I1, const R& guess, CutOf<R>& c
) {
  const GrainsOf<R> grains = loaded_grains(law.constituents, c.pores, rise_of_I1);
  const FilledOf<R> f = fill_pores(law.constituents, c.pores, grains, R{}, guess);
  assign_where(torn, f.end, c.pores);
}

/// Takes an opening from a state.
/// @param m       moduli of the skeleton
/// @param bulk    as the opening sees it: the fluid's pressure falls with it
/// @param bounds  sum of those at both ends of the opening [stress]
template <class R, class Law>
BARRENO_FUNCTION void take_opening(
    const Law& law,
    const MaskOf<R>& torn,
    const OpeningOf<R>& o,
    const Sym3Of<R>& strain,
    const ModuliOf<R>& m,
    const R& bulk,
    const R& bounds,
    CutOf<R>& c
) {
  constexpr double third = 1.0 / 3.0;
  const R fall = 3.0 * bulk * o.sum, before = c.pores.pressure;
  const Sym3Of<R> shear = R(2.0 * m.shear) * (strain - isotropic(R(third * o.sum)));
  R missed = fall;
  if constexpr (has_poroplastic_fluid<Law>) {
    const R guess = R{} - fall_of(law.constituents, c.pores, m.bulk) * o.sum;
    widen_pores(law, torn, R(-fall), guess, c);
    missed = fall + (3.0 * law.constituents.per_matrix) * m.bulk * (c.pores.pressure - before);
  }
  const R fall_of_I1 = fall + 3.0 * (c.pores.pressure - before);
  const R work = 0.5 * (fall_of_I1 * (third * c.dv) + contract(shear, c.de));
  const R opened = 0.5 * bounds * o.sum;
  c.elastic_work = real::select(torn, c.elastic_work - work - opened, c.elastic_work);
  c.plastic_work = real::select(torn, c.plastic_work + opened, c.plastic_work);
  c.x = real::select(torn, c.x - fall, c.x);
  assign_where(torn, c.s - shear, c.s);
  assign_where(torn, c.missed + shear + isotropic(R(third * missed)), c.missed);
  c.evp = real::select(torn, c.evp + o.sum, c.evp);
  const R sheared = real::sqrt(R((4.0 / 3.0) * o.squares()));
  c.shear_strain = real::select(torn, c.shear_strain + sheared, c.shear_strain);
}

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

/// Opens cracks where a principal effective stress exceeds its bound.
/// @return where it does
template <class R, class Law>
BARRENO_ALIKE MaskOf<R> open_cracks(const Law& law, const MaskOf<R>& asked, CutOf<R>& c) {
  const R whole = law.tension.cutoff * c.coherence;
  PrincipalOf<R> principal = principal_of(asked, c.s);
  const ModuliOf<R> m = law.elasticity.moduli_at(c.x, c.evp);
  R bulk = m.bulk;
  if constexpr (has_poroplastic_fluid<Law>) {
    const double per_matrix = law.constituents.per_matrix;
    bulk = bulk * (1.0 + per_matrix * fall_of(law.constituents, c.pores, m.bulk));
  }
  CracksOf<R> cracks;
  cracks.twice_shear = 2.0 * m.shear;
  cracks.lambda = bulk - (1.0 / 3.0) * cracks.twice_shear;
  for (int k = 0; k < 3; ++k) {
    principal.value[k] = principal.value[k] + c.x * (1.0 / 3.0);
    cracks.stress[k] = principal.value[k];
  }
  sort_falling(cracks.stress);
  const R bound = (1.0 - c.damage) * whole;
  const MaskOf<R> torn = asked & (cracks.stress[0] > bound);
  if (!real::any(torn)) return torn;
  const R per_strain = c.taken / c.fracture_strain;
  const R damage = damage_of_opening(torn, cracks, whole, c.damage, per_strain);
  const R lower = (1.0 - damage) * whole;
  const OpeningOf<R> o = cracks.opening(lower);
  const Sym3Of<R> strain = strain_of(principal, cracks, lower, o.sum);
  take_opening(law, torn, o, strain, m, bulk, R(bound + lower), c);
  c.damage = real::select(torn, damage, c.damage);
  return torn;
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

/// What the bound on tension reads of steps, and the end of torn ones.
/// @param holder of the points' coherence and damage: a history or a step
template <class R, class Holder>
BARRENO_FUNCTION CutOf<R> cut_of(const Holder& holder) {
  CutOf<R> c{};
  c.coherence = holder.coherence;
  c.fracture_strain = holder.fracture_strain;
  c.damage = holder.damage;
  return c;
}
template <class R, class Holder, class End>
BARRENO_FUNCTION CutOf<R> begin_cut(
    const Holder& holder, const R& dv, const Sym3Of<R>& de, const End& end
) {
  CutOf<R> c = cut_of<R>(holder);
  c.dv = dv;
  c.de = de;
  c.elastic_work = end.elastic_work;
  c.plastic_work = end.plastic_work;
  c.pores = end.pores;
  return c;
}
template <class R, class End>
BARRENO_FUNCTION void end_cut(const MaskOf<R>& torn, const CutOf<R>& c, End& end) {
  assign_where(torn, c.s + isotropic(R(c.x * (1.0 / 3.0) - c.pores.pressure)), end.stress);
  end.pores = c.pores;
  end.elastic_work = c.elastic_work;
  end.plastic_work = c.plastic_work;
}

/// Opening of steps as if they were elastic, taken off the states that they begin with. Where bound
/// and surface hold together most of the strain opens cracks. A surface that is asked first would
/// take that strain for flow that dilates, and press the sides.
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
  const ModuliOf<R>& m = n.elastic.moduli;
  const R rise = 3.0 * m.bulk * skeleton_guess<R>(rock, n, m.bulk);
  const Sym3Of<R> change = R(2.0 * m.shear) * n.de;
  const Sym3Of<R> s = n.s + change;
  const R bound = tension_bound(law, c.damage, c.coherence);
  const MaskOf<R> near = near_bound(law, flows, bound, R(n.x + rise), s);
  if (!real::any(near)) return near;
  // The work of a step is that of the mean of its ends, and here it is the first that is lower.
  c.dv = -n.dv;
  c.de = -1.0 * n.de;
  c.x = n.x + rise;
  c.s = s;
  c.evp = n.evp;
  if constexpr (Law::wet) c.pores = n.pores;
  const MaskOf<R> torn = open_cracks(law, near, c);
  n.x = real::select(torn, c.x - rise, n.x);
  assign_where(torn, c.s - change, n.s);
  n.evp = c.evp;
  if constexpr (Law::wet) n.pores = c.pores;
  if (real::any(torn)) assign_where(torn, rock.elasticity.state_at(n.x, n.evp), n.elastic);
  return torn;
}

/// The bound on principal tension at the end of steps.
/// @param s  shear stress, which the bound turns out of the plane of the step
/// @param[in,out] step  all but that
/// @param[in,out] end   stress, pores and works
/// @return what the step misses of an elastic one by the bound [stress]
template <class R, class Law, class Points, class End>
BARRENO_FUNCTION Sym3Of<R> cut_step(
    const Law& law,
    const MaskOf<R>& good,
    const Points& p,
    const Sym3Of<R>& s,
    StepOf<R, Law>& step,
    End& end
) {
  const R bound = tension_bound(law, step.damage, step.coherence);
  const MaskOf<R> near = near_bound(law, good, bound, step.state.x, s);
  if (!real::any(near)) return {};
  CutOf<R> c = begin_cut<R>(step, R(step.dv), deviator(p.increment.strain), end);
  if constexpr (Law::rated) c.taken = step.taken;
  c.x = step.state.x;
  c.s = s;
  c.evp = step.state.evp;
  c.shear_strain = step.state.shear_strain;
  const MaskOf<R> torn = open_cracks(law, near, c);
  if (!real::any(torn)) return {};
  step.damage = c.damage;
  step.state.x = c.x;
  step.state.evp = c.evp;
  step.state.shear_strain = c.shear_strain;
  step.elastic_work = c.elastic_work;
  step.plastic_work = c.plastic_work;
  if constexpr (Law::wet) step.pores = c.pores;
  end_cut(torn, c, end);
  return c.missed;
}

}  // namespace barreno::arenisca
