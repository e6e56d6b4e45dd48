// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/rock.hpp"

#include <cmath>
#include <type_traits>

namespace barreno::arenisca {

// Pore fluid of one or several points (docs/method.md 10): the dry law holds for the effective
// stress sigma + p I and for the strain of the skeleton,
//
//   d eps + dp/(3 Km) I,
//
// and the volumes of grains and fluid tell p. Per current volume, at the start of a step,
//
//   solid exp(-(dP'/solid + dp)/Km) + fluid exp(-dp/Kf) = exp(d eps_v)      where the pores are
//   full
//
// with P' the mean effective pressure; else gas fills the rest and p = 0. Under the pressures of a
// jet the moduli change, and so do the volumes (10.6 to 10.9). To first order this is Biot's law
// with alpha = 1 - K/Km and 1/M = (alpha - phi)/Km + phi/Kf, plastic volume strain included (O.
// Coussy, Poromechanics, 2004).

/// Pores of points: volumes over the volume, and the fluid's pressure.
template <class R>
struct PoresOf {
  R pressure{};  ///< p >= 0 [stress]
  R solid{};     ///< 1 - porosity
  R fluid{};     ///< porosity where there is no gas
};

/// What a structure of a step holds besides where there is fluid: nothing in dry rock.
template <class R, bool wet>
struct WithPores {};
template <class R>
struct WithPores<R, true> {
  PoresOf<R> pores;
};

/// Pores of a history, whose names are those of history_table(), and back.
template <class R, class History>
BARRENO_FUNCTION PoresOf<R> pores_of(const History& h) {
  return {h.pore_pressure, 1.0 - h.porosity, h.porosity - h.gas};
}
template <class R, class History>
BARRENO_FUNCTION void set_pores(const MaskOf<R>& choice, const PoresOf<R>& pores, History& h) {
  const R porosity = 1.0 - pores.solid;
  h.pore_pressure = real::select(choice, pores.pressure, h.pore_pressure);
  h.porosity = real::select(choice, porosity, h.porosity);
  h.gas = real::select(choice, real::larger(R(porosity - pores.fluid), 0.0), h.gas);
}

/// Compliances of grains and fluid in a state [1/stress].
template <class R>
struct CompliancesOf {
  R whole;  ///< 1/Km at the total pressure P
  R alone;  ///< 1/Km at the pressure of the fluid
  R fluid;  ///< 1/Kf at that
};
/// Those of moduli that change; a function of its own, so that constant ones need not carry it.
template <class R>
BARRENO_ALIKE CompliancesOf<R> changed_compliances(
    const Constituents& c, const R& pressure, const R& x
) {
  return {
      c.grain_compliance(R(pressure - x * (1.0 / 3.0))),
      c.grain_compliance(pressure),
      c.fluid_compliance(pressure)};
}
/// @param x  I1 of the effective stress [stress]
template <class R>
BARRENO_FUNCTION CompliancesOf<R> compliances_at(
    const Constituents& c, const PoresOf<R>& n, const R& x
) {
  if (c.change) return changed_compliances(c, n.pressure, x);
  return {R{} + c.per_matrix, R{} + c.per_matrix, R{} + c.per_fluid};
}

/// Bulk modulus of the drained rock whose grains are under the pressure of a fluid too (docs/
/// method.md, 10.8): the compliance of the pores is that of dry rock under the effective pressure,
/// and that of the grains is theirs at the total one.
///
/// Where the fluid is stiffer than half of the grains, pores soften the rock by as much as they
/// must so that they store half of what their fluid alone would (10.9): the dry law, which knows no
/// porosity, lets them soften it by less.
/// @param dry  bulk modulus of dry rock under the effective stress [stress]
template <class R>
BARRENO_ALIKE R
bulk_of_pressed_grains(const Constituents& c, const PoresOf<R>& n, const R& x, const R& dry) {
  const CompliancesOf<R> k = changed_compliances(c, n.pressure, x);
  const R of_pores = 1.0 / dry - c.grain_compliance(R(x * (-1.0 / 3.0)));
  const R excess = (1.0 - n.solid) * (k.alone - 0.5 * k.fluid);
  const R asked = smaller_of(real::larger(excess, 0.0), R(0.9 * k.whole));
  const R least = asked * k.whole / (k.whole - asked);
  return real::select(n.pressure > 0.0, 1.0 / (larger_of(of_pores, least) + k.whole), dry);
}
template <class R>
BARRENO_FUNCTION R
bulk_under_pressure(const Constituents& c, const PoresOf<R>& n, const R& x, const R& dry) {
  if (c.change) return bulk_of_pressed_grains(c, n, x, dry);
  return dry;
}

/// Logarithm of the grains' volume ratio as a function of the rise of p: begin + slope dp.
template <class R>
struct GrainsOf {
  R begin;
  R slope;  ///< [1/stress]

  static constexpr bool change = false;
  BARRENO_FUNCTION GrainsOf at(const R& rise) const { return {begin + slope * rise, slope}; }
};
/// Elastic rock of this bulk modulus: dP' = -K (d eps_v + dp/Km).
template <class R>
BARRENO_FUNCTION GrainsOf<R> elastic_grains(
    const Constituents& c, const PoresOf<R>& n, const R& bulk, const R& volume_strain
) {
  const R stiffness = bulk * c.per_matrix / n.solid;
  return {stiffness * volume_strain, (stiffness - 1.0) * c.per_matrix};
}
/// Rock of which the effective stress is known: a rise of I1 by this.
template <class R>
BARRENO_FUNCTION GrainsOf<R> loaded_grains(
    const Constituents& c, const PoresOf<R>& n, const R& rise_of_I1
) {
  return {rise_of_I1 * ((1.0 / 3.0) * c.per_matrix) / n.solid, R{} - c.per_matrix};
}

/// The same of grains whose modulus changes (docs/method.md, 10.6):
/// -(F(P) - phi F(p))/solid from the start of the step, P' = effective - fall dp.
template <class R>
struct ChangingGrainsOf {
  const Constituents& c;
  R solid, pressure;  ///< at the start
  R start;            ///< F(P) - phi F(p) there
  R effective, fall;

  static constexpr bool change = true;
  /// @param x  I1 of the effective stress at the start [stress]
  BARRENO_FUNCTION ChangingGrainsOf(
      const Constituents& law,
      const PoresOf<R>& n,
      const R& x,
      const R& effective_end,
      const R& falls
  )
      : c(law), solid(n.solid), pressure(n.pressure), effective(effective_end), fall(falls) {
    start =
        c.grain_strain(R(pressure - x * (1.0 / 3.0))) - (1.0 - solid) * c.grain_strain(pressure);
  }
  BARRENO_FUNCTION GrainsOf<R> at(const R& rise) const {
    const R p = pressure + rise, whole = p + effective - fall * rise, phi = 1.0 - solid;
    const R strain = c.grain_strain(whole) - phi * c.grain_strain(p) - start;
    const R slope = c.grain_compliance(whole) * (1.0 - fall) - phi * c.grain_compliance(p);
    const R per_solid = -1.0 / solid;
    return {strain * per_solid, slope * per_solid};
  }
};

/// Grains of which only the tangent is known, beside a fluid whose modulus changes.
template <class R>
struct TangentGrainsOf : GrainsOf<R> {
  static constexpr bool change = true;
};

/// Where the fluid is and what it does when the volume changes.
template <class R>
struct FilledOf {
  PoresOf<R> end;
  R rise;              ///< of the pressure [stress]
  MaskOf<R> unsolved;  ///< where no pressure was found
};

/// Keeps Newton's method for volumes that are not convex in the pressure between the pressures that
/// are known to be too low and too high.
template <class R>
struct BracketOf {
  R low = R{} - HUGE_VAL, high = R{} + HUGE_VAL;

  BARRENO_FUNCTION R next(const R& rise, const R& excess, const R& softness, double farther) {
    low = real::select(excess > 0.0, rise, low);
    high = real::select(excess < 0.0, rise, high);
    const R newton = rise + excess / softness;
    const MaskOf<R> sound = (softness > 0.0) & (newton >= low) & (newton <= high);
    const R middle = real::select(high < HUGE_VAL, 0.5 * (low + high), rise + farther);
    return real::select(sound, newton, middle);
  }
};

/// Pressure and volumes at the end of a volume strain.
///
/// The volume that grains and fluid of constant moduli want is convex in p and falls: Newton's
/// method converges from any start, kept at p = 0, where gas comes in. In rubble with much gas the
/// volume rises with p. The lowest pressure counts there, so the search goes back to p = 0.
/// @param grains  GrainsOf, ChangingGrainsOf or TangentGrainsOf
/// @param guess of the rise of the pressure [stress]
template <class R, class Grains>
BARRENO_FUNCTION FilledOf<R> fill_pores(
    const Constituents& c,
    const PoresOf<R>& n,
    const Grains& grains,
    const R& volume_strain,
    const R& guess
) {
  constexpr int max_iterations = 50;
  constexpr double nothing = 1e-13;  // of volume: beyond round-off
  const R volume = real::exp(volume_strain);
  const R least = -n.pressure;
  const MaskOf<R> dry = !(n.fluid > 0.0);
  [[maybe_unused]] R fluid_strain{};
  if constexpr (Grains::change) fluid_strain = c.fluid_strain(n.pressure);
  R rise = real::select(dry, least, larger_of(guess, least));
  R solid{}, fluid{};
  [[maybe_unused]] BracketOf<R> bracket;
  // A point that has its answer keeps it: its bits must not depend on the other points.
  MaskOf<R> open = !none_of<R>();
  for (int i = 0; i < max_iterations; ++i) {
    const GrainsOf<R> here = grains.at(rise);
    const R solid_here = n.solid * real::exp(here.begin);
    R fluid_here{}, per_fluid = R{} + c.per_fluid;
    if constexpr (Grains::change) {
      const R pressure = n.pressure + rise;
      per_fluid = c.fluid_compliance(pressure);
      fluid_here = n.fluid * real::exp(R(fluid_strain - c.fluid_strain(pressure)));
    } else {
      fluid_here = n.fluid * real::exp(R(-c.per_fluid * rise));
    }
    const R excess = solid_here + fluid_here - volume;
    const R softness = fluid_here * per_fluid - solid_here * here.slope;
    R newton = real::select(softness > 0.0, rise + excess / softness, least);
    if constexpr (Grains::change) newton = bracket.next(rise, excess, softness, c.fluid);
    const R next = real::select(dry, rise, larger_of(newton, least));
    const R step = next - rise;
    // The error that is left is that of the parabola: (step/Kf)^2.
    const R left = step * c.per_fluid;
    rise = real::select(open, next, rise);
    // To first order beyond what was evaluated.
    solid = real::select(open, R(solid_here * (1.0 + here.slope * step)), solid);
    fluid = real::select(open, R(fluid_here * (1.0 - step * per_fluid)), fluid);
    // The volume is too large and rises: no pressure makes it fit.
    const MaskOf<R> stuck = (excess > 0.0) & !(dry | (softness > 0.0));
    open = open & ((left * left > nothing) | stuck);
    if (!real::any(open)) break;
  }
  const R per_volume = 1.0 / volume;
  FilledOf<R> f;
  f.rise = rise;
  f.unsolved = open;
  f.end.pressure = real::larger(R(n.pressure + rise), 0.0);
  f.end.solid = real::smaller(R(solid * per_volume), 1.0);
  const R room = 1.0 - f.end.solid;
  f.end.fluid = real::select(f.end.pressure > 0.0, room, smaller_of(R(fluid * per_volume), room));
  return f;
}

/// The same where moduli change.
template <class R, class Grains>
BARRENO_ALIKE FilledOf<R> fill_changing_pores(
    const Constituents& c,
    const PoresOf<R>& n,
    const Grains& grains,
    const R& volume_strain,
    const R& guess
) {
  return fill_pores(c, n, grains, volume_strain, guess);
}

/// Pores at the end of an elastic step of this bulk modulus.
/// @param x           I1 of the effective stress at its start [stress]
/// @param per_matrix  1/Km on its way [1/stress]
template <class R>
BARRENO_FUNCTION FilledOf<R> fill_elastic_pores(
    const Constituents& c,
    const PoresOf<R>& n,
    const R& x,
    const R& per_matrix,
    const R& bulk,
    const R& volume_strain,
    const R& guess
) {
  if (!c.change)
    return fill_pores(c, n, elastic_grains(c, n, bulk, volume_strain), volume_strain, guess);
  const R effective = x * (-1.0 / 3.0) - bulk * volume_strain;
  const ChangingGrainsOf<R> grains(c, n, x, effective, R(bulk * per_matrix));
  return fill_changing_pores(c, n, grains, volume_strain, guess);
}
/// Pores at the end of a step that ends with this I1 of the effective stress.
template <class R>
BARRENO_FUNCTION FilledOf<R> fill_loaded_pores(
    const Constituents& c,
    const PoresOf<R>& n,
    const R& x,
    const R& x_end,
    const R& volume_strain,
    const R& guess
) {
  if (!c.change) return fill_pores(c, n, loaded_grains(c, n, R(x_end - x)), volume_strain, guess);
  const ChangingGrainsOf<R> grains(c, n, x, R(x_end * (-1.0 / 3.0)), R{});
  return fill_changing_pores(c, n, grains, volume_strain, guess);
}

/// What follows from compliances, numbers where they are constant and points' own where they
/// change.
template <class R, class Rule>
BARRENO_FUNCTION R
with_compliances(const Constituents& c, const PoresOf<R>& n, const R& x, const Rule& rule) {
  if (c.change) return rule(changed_compliances(c, n.pressure, x));
  return rule(CompliancesOf<double>{c.per_matrix, c.per_matrix, c.per_fluid});
}

/// 1/M at fixed skeleton: what a unit of pressure stores in full pores [1/stress].
template <class R, class Number>
BARRENO_FUNCTION R storage_of(const CompliancesOf<Number>& k, const PoresOf<R>& n, const R& bulk) {
  const R phi = 1.0 - n.solid;
  R of_grains = (n.solid - bulk * k.whole) * k.whole;
  if constexpr (std::is_same_v<R, Number>) of_grains = of_grains + phi * (k.whole - k.alone);
  return of_grains + phi * k.fluid;
}

/// Fall of the pressure for a plastic volume strain of 1 at fixed total strain: (1 - alpha) M; 0
/// where gas gives way [stress].
/// @param x  I1 of the effective stress [stress]
template <class R>
BARRENO_FUNCTION R fall_of(const Constituents& c, const PoresOf<R>& n, const R& x, const R& bulk) {
  return with_compliances(c, n, x, [&](const auto& k) {
    const R stiffness = bulk * k.whole / storage_of(k, n, bulk);
    return R(real::select(n.pressure > 0.0, stiffness, 0.0));
  });
}

/// Strain of the skeleton in an elastic volume strain, to first order; more fluid than pores
/// stretches it.
/// @param x  I1 of the effective stress [stress]
template <class R>
BARRENO_FUNCTION R skeleton_guess(
    const Constituents& c, const PoresOf<R>& n, const R& x, const R& bulk, const R& volume_strain
) {
  return with_compliances(c, n, x, [&](const auto& k) {
    const R biot = 1.0 - bulk * k.whole;
    const R excess = n.solid + n.fluid - 1.0;
    const R rise = (excess - biot * volume_strain) / storage_of(k, n, bulk);
    const MaskOf<R> full = (n.pressure > 0.0) | (excess > 0.0);
    return R(volume_strain + real::select(full, rise * k.whole, 0.0));
  });
}

/// Undrained bulk modulus: K + alpha^2 M, Gassmann's; K where gas gives way [stress].
/// @param x  I1 of the effective stress [stress]
template <class R>
BARRENO_FUNCTION R
undrained_bulk(const Constituents& c, const PoresOf<R>& n, const R& x, const R& bulk) {
  return with_compliances(c, n, x, [&](const auto& k) {
    const R biot = 1.0 - bulk * k.whole;
    return R(bulk + real::select(n.pressure > 0.0, biot * biot / storage_of(k, n, bulk), 0.0));
  });
}

// The same for any rock: `holder` is a structure of a step, with pores where the rock has them.

/// Fluid in the pores by their volumes; not that of the forms about a centre.
template <class Rock>
inline constexpr bool has_poroplastic_fluid = Rock::wet && !Rock::about_centre;

/// The pores of points before a step. About a centre, their pressure is that of the centre.
template <class R, class Rock, class History>
BARRENO_FUNCTION PoresOf<R> pores_before(const Rock& rock, const History& h) {
  if constexpr (Rock::about_centre)
    return {rock.zeta(h.plastic_volume_strain) / -3.0};
  else if constexpr (Rock::wet)
    return pores_of<R>(h);
  else
    return {};
}
/// Strain of the skeleton in an elastic step, to first order.
/// @param x  I1 of the effective stress at its start [stress]
template <class R, class Rock, class Step>
BARRENO_FUNCTION R skeleton_guess(const Rock& rock, const Step& step, const R& x, const R& bulk) {
  if constexpr (has_poroplastic_fluid<Rock>)
    return skeleton_guess(rock.constituents, step.pores, x, bulk, step.dv);
  else
    return step.dv;
}
/// Bulk modulus with the fluid that cannot leave [stress].
/// @param x  I1 of the effective stress [stress]
template <class R, class Rock, class Holder>
BARRENO_FUNCTION R bulk_of(const Rock& rock, const Holder& holder, const R& x, const R& drained) {
  if constexpr (has_poroplastic_fluid<Rock>)
    return undrained_bulk(rock.constituents, holder.pores, x, drained);
  else
    return drained;
}
/// Moduli of dry rock into those under the pressure of a fluid.
/// @param x  I1 of the effective stress [stress]
template <class R, class Rock, class Holder, class Moduli>
BARRENO_FUNCTION void press_moduli(
    const Rock& rock, const Holder& holder, const R& x, Moduli& moduli
) {
  if constexpr (has_poroplastic_fluid<Rock>)
    moduli.bulk = bulk_under_pressure(rock.constituents, holder.pores, x, moduli.bulk);
}
/// 1/Km on the way between two states, by the mean of their total pressures [1/stress].
/// @param x  sum of both I1 of the effective stress [stress]
template <class R>
BARRENO_FUNCTION R
per_matrix_between(const Constituents& c, const R& both_pressures, const R& both_x) {
  if (!c.change) return R{} + c.per_matrix;
  return c.grain_compliance(R(0.5 * both_pressures - (0.5 / 3.0) * both_x));
}
/// Error of the effective stress from 1/Km that changed on the way; of moduli that change [stress].
template <class R>
BARRENO_ALIKE R error_of_grains(
    const Constituents& c,
    const PoresOf<R>& begin,
    const R& x_begin,
    const PoresOf<R>& end,
    const R& x_end,
    const R& per_matrix,
    const R& bulk
) {
  constexpr double root_3 = 1.7320508075688772;
  const R mean = 0.5 * (c.grain_compliance(R(begin.pressure - x_begin * (1.0 / 3.0))) +
                        c.grain_compliance(R(end.pressure - x_end * (1.0 / 3.0))));
  return root_3 * bulk * real::abs(R((mean - per_matrix) * (end.pressure - begin.pressure)));
}
/// Into a history whose plastic strain is that of the end.
/// @param x  I1 of the effective stress [stress]
template <class R, class Rock, class History>
BARRENO_FUNCTION void keep_pores(
    const Rock& rock, const MaskOf<R>& choice, const R& x, const PoresOf<R>& pores, History& h
) {
  if constexpr (has_poroplastic_fluid<Rock>)
    set_pores<R>(choice, pores, h);
  else if constexpr (Rock::about_centre)
    tell_pores(rock, choice, x, h);
}
/// The pores of one structure into another.
template <class Rock, class Mask, class From, class To>
BARRENO_FUNCTION void assign_pores(const Mask& choice, const From& from, To& to) {
  if constexpr (Rock::wet) assign_where(choice, from.pores, to.pores);
}

}  // namespace barreno::arenisca
