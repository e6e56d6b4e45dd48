// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points_step.hpp"
#include "barreno/outcome.hpp"

namespace barreno::arenisca {

// Start of a step of one or several points: elastic steps, which need no more, and what the others
// start from.

/// Norm of a strain increment beyond which input is absurd.
constexpr double largest_increment = 10.0;

/// NaN, infinite or absurd input, see Arenisca::sound_input().
template <class R>
BARRENO_FUNCTION MaskOf<R> sound_points(
    const IncrementOf<Sym3Of<R>>& i, const Sym3Of<R>& stress, const R& evp, const R& shear_strain
) {
  const R sum =
      contract(stress, stress) + evp + shear_strain + i.volume_ratio_begin + i.volume_ratio_end;
  return (contract(i.strain, i.strain) <= largest_increment * largest_increment) &
         real::is_finite(sum);
}

/// Whether a step can have made this plastic volume strain: no more than the largest increment
/// holds. Where a step ends far beyond, its works are large parts that cancel.
template <class R>
BARRENO_FUNCTION MaskOf<R> sound_end(const R& evp_begin, const R& evp_end) {
  return real::abs(R(evp_end - evp_begin)) <= 2.0 * largest_increment;
}

/// Elastic prediction of whole steps.
template <class R, class Law>
struct WholeStepOf : WithPores<R, Law::wet> {
  MaskOf<R> inside;
  R x;
  Sym3Of<R> s;
  ModuliOf<R> used;
};
/// Start of a step in invariants.
template <class R, class Law>
struct StartOf : WithPores<R, Law::wet> {
  R x;
  Sym3Of<R> s;
  R evp;
  R dv;
  Sym3Of<R> de;
  ElasticStateOf<R> elastic;
};

template <class R, class Law>
BARRENO_FUNCTION WholeStepOf<R, Law> predict_whole_step(
    const RockOf<R, Law>& rock,
    const StartOf<R, Law>& n,
    const CapOf<R>& cap,
    const MaskOf<R>& asked
) {
  WholeStepOf<R, Law> p;
  R strain = skeleton_guess<R>(rock, n, n.x, n.elastic.moduli.bulk);
  const MiddleOf<R> middle = used_moduli(rock, n, strain, cap, n.elastic);
  p.used = middle.moduli;
  if constexpr (Law::wet) p.pores = n.pores;
  [[maybe_unused]] MaskOf<R> unsolved = none_of<R>();
  if constexpr (has_poroplastic_fluid<Law>) {
    const Constituents& c = rock.constituents;
    const R guess = (strain - n.dv) * c.matrix;
    const R& bulk = p.used.bulk;
    const FilledOf<R> f = fill_elastic_pores(c, n.pores, n.x, middle.per_matrix, bulk, n.dv, guess);
    p.pores = f.end;
    unsolved = f.unsolved;
    strain = n.dv + f.rise * middle.per_matrix;
  }
  p.x = n.x + 3.0 * p.used.bulk * strain;
  p.s = n.s + R(2.0 * p.used.shear) * n.de;
  R J2 = 0.5 * contract(p.s, p.s);
  // Inside at the weakest angle is inside: most points need no angle.
  if constexpr (Law::angled) J2 = J2 * (1.0 / (rock.weakest * rock.weakest));
  p.inside = contains(rock.surface, asked, p.x, J2, cap);
  if constexpr (has_poroplastic_fluid<Law>) p.inside = p.inside & !unsolved;
  return p;
}

/// Error of the effective stress of whole steps from grains that change on the way, relative to it.
template <class R, class Law>
BARRENO_ALIKE R relative_error_of_grains(
    const RockOf<R, Law>& rock, const StartOf<R, Law>& n, const WholeStepOf<R, Law>& p
) {
  const Constituents& c = rock.constituents;
  const R pressures = n.pores.pressure + p.pores.pressure;
  const R per_matrix = per_matrix_between(c, pressures, R(n.x + p.x));
  const R error = error_of_grains(c, n.pores, n.x, p.pores, p.x, per_matrix, p.used.bulk);
  const R size = size_of_stress(p.x, R(0.5 * contract(p.s, p.s)));
  return error / real::larger(size, rock.stress_floor);
}

/// Whole steps that are elastic with moduli that hardly change.
/// @param[out] outcome of those
/// @return where it is so
template <class R, class Law>
BARRENO_FUNCTION MaskOf<R> step_elastically(
    const RockOf<R, Law>& rock,
    const StartOf<R, Law>& n,
    const MaskOf<R>& asked,
    WholeStepOf<R, Law>& p,
    PointsOutcome<R>& outcome
) {
  // Inside the virgin rock's surface is inside that of compacted rock: no logarithm is needed.
  MaskOf<R> virgin = asked & (n.evp <= 0.0);
  if constexpr (Law::about_centre) virgin = none_of<R>();  // the fluid may draw the cap in
  p = predict_whole_step(rock, n, same_cap<R>(rock.first_cap), virgin);
  const MaskOf<R> open = asked & !p.inside;
  if (real::any(open)) {
    const WholeStepOf<R, Law> own = predict_whole_step(rock, n, cap_of(rock, n.evp), open);
    p.x = real::select(open, own.x, p.x);
    assign_where(open, own.s, p.s);
    assign_where(open, own.used, p.used);
    p.inside = p.inside | own.inside;
    assign_pores<Law>(open, own, p);
  }
  ModuliOf<R> end = rock.elasticity.moduli_after(p.inside, n.elastic, p.x);
  press_moduli(rock, p, p.x, end);
  outcome.elastic_work = 0.5 * ((n.x + p.x) * (n.dv * (1.0 / 3.0)) + contract(n.s + p.s, n.de));
  outcome.plastic_work = R{};
  if constexpr (Law::wet)
    outcome.elastic_work =
        outcome.elastic_work - 0.5 * (n.pores.pressure + p.pores.pressure) * n.dv;
  outcome.longitudinal_modulus = bulk_of<R>(rock, p, p.x, end.bulk) + (4.0 / 3.0) * end.shear;
  // Ahead of a wave strains are as small as 1e-300. Where such a step passes the jump of the moduli
  // the squares that find the place are no longer exact, and nothing depends on it.
  constexpr double negligible = 1e-30;
  const MaskOf<R> still = contract(n.de, n.de) + n.dv * n.dv < negligible * negligible;
  // |d sigma| <= 2 max(|sigma_n|, |sigma_n1|): no need to measure the stresses.
  R error = 2.0 * mismatch_of(n.elastic.moduli, p.used, end);
  if constexpr (has_poroplastic_fluid<Law>)
    if (rock.constituents.change) error = error + relative_error_of_grains(rock, n, p);
  return p.inside & (still | (error <= rock.tolerance));
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

/// First state of the steps asked for, in their planes if the law lets them.
template <class R, class Law>
BARRENO_FUNCTION StepOf<R, Law> begin_step(
    const RockOf<R, Law>& rock,
    const StartOf<R, Law>& n,
    const R& shear_strain,
    const MaskOf<R>& asked
) {
  constexpr double min_fraction = 1.0 / 1024.0, smallest_strain = 1e-5;
  StepOf<R, Law> step;
  step.state.x = n.x;
  step.state.evp = n.evp;
  step.state.shear_strain = shear_strain;
  step.cap = cap_of(rock, n.evp);
  step.dv = n.dv;
  if constexpr (Law::angled) {
    step.state.s = {n.s};
    step.de = {n.de};
  } else {
    const PlaneOf<R> plane = plane_of(n.s, n.de);
    step.state.s = {plane.s_size, R{}};
    step.de = {plane.along * plane.s_size, plane.across_size};
  }
  const R size = size_of_stress(n.dv, squared(step.de));
  const MaskOf<R> large = size * min_fraction > smallest_strain;
  step.smallest = real::select(large, smallest_strain / size, min_fraction);
  step.active = asked;
  if constexpr (Law::wet) step.pores = n.pores;
  return step;
}

}  // namespace barreno::arenisca
