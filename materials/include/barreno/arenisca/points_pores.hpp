// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/rock.hpp"

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
// with P' the mean effective pressure; else gas fills the rest and p = 0. To first order this is
// Biot's law with alpha = 1 - K/Km and 1/M = (alpha - phi)/Km + phi/Kf, plastic volume strain
// included (O. Coussy, Poromechanics, 2004).

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

/// Logarithm of the grains' volume ratio as a function of the rise of p: begin + slope dp.
template <class R>
struct GrainsOf {
  R begin;
  R slope;  ///< [1/stress]
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

/// Where the fluid is and what it does when the volume changes.
template <class R>
struct FilledOf {
  PoresOf<R> end;
  R rise;  ///< of the pressure [stress]
};

/// Pressure and volumes at the end of a volume strain.
///
/// The volume that grains and fluid want falls with p and is convex: Newton's method converges from
/// any start, kept at p = 0, where gas comes in.
/// @param guess of the rise of the pressure [stress]
template <class R>
BARRENO_FUNCTION FilledOf<R> fill_pores(
    const Constituents& c,
    const PoresOf<R>& n,
    const GrainsOf<R>& grains,
    const R& volume_strain,
    const R& guess
) {
  constexpr int max_iterations = 50;
  constexpr double nothing = 1e-13;  // of volume: beyond round-off
  const R volume = real::exp(volume_strain);
  const R least = -n.pressure;
  const MaskOf<R> dry = !(n.fluid > 0.0);
  R rise = real::select(dry, least, larger_of(guess, least));
  R solid{}, fluid{};
  // A point that has its answer keeps it: its bits must not depend on the other points.
  MaskOf<R> open = !none_of<R>();
  for (int i = 0; i < max_iterations; ++i) {
    const R solid_here = n.solid * real::exp(R(grains.begin + grains.slope * rise));
    const R fluid_here = n.fluid * real::exp(R(-c.per_fluid * rise));
    const R excess = solid_here + fluid_here - volume;
    const R softness = fluid_here * c.per_fluid - solid_here * grains.slope;
    const R next = real::select(dry, rise, larger_of(R(rise + excess / softness), least));
    const R step = next - rise;
    // The error that is left is that of the parabola: (step/Kf)^2.
    const R left = step * c.per_fluid;
    rise = real::select(open, next, rise);
    // To first order beyond what was evaluated.
    solid = real::select(open, R(solid_here * (1.0 + grains.slope * step)), solid);
    fluid = real::select(open, R(fluid_here * (1.0 - left)), fluid);
    open = open & (left * left > nothing);
    if (!real::any(open)) break;
  }
  const R per_volume = 1.0 / volume;
  FilledOf<R> f;
  f.rise = rise;
  f.end.pressure = real::larger(R(n.pressure + rise), 0.0);
  f.end.solid = real::smaller(R(solid * per_volume), 1.0);
  const R room = 1.0 - f.end.solid;
  f.end.fluid = real::select(f.end.pressure > 0.0, room, smaller_of(R(fluid * per_volume), room));
  return f;
}

/// 1/M at fixed skeleton: what a unit of pressure stores in full pores [1/stress].
template <class R>
BARRENO_FUNCTION R storage_of(const Constituents& c, const PoresOf<R>& n, const R& bulk) {
  const R phi = 1.0 - n.solid;
  return (n.solid - bulk * c.per_matrix) * c.per_matrix + phi * c.per_fluid;
}

/// Fall of the pressure for a plastic volume strain of 1 at fixed total strain: (1 - alpha) M; 0
/// where gas gives way [stress].
template <class R>
BARRENO_FUNCTION R fall_of(const Constituents& c, const PoresOf<R>& n, const R& bulk) {
  const R stiffness = bulk * c.per_matrix / storage_of(c, n, bulk);
  return real::select(n.pressure > 0.0, stiffness, 0.0);
}

/// Strain of the skeleton in an elastic volume strain, to first order; more fluid than pores
/// stretches it.
template <class R>
BARRENO_FUNCTION R
skeleton_guess(const Constituents& c, const PoresOf<R>& n, const R& bulk, const R& volume_strain) {
  const R biot = 1.0 - bulk * c.per_matrix;
  const R excess = n.solid + n.fluid - 1.0;
  const R rise = (excess - biot * volume_strain) / storage_of(c, n, bulk);
  const MaskOf<R> full = (n.pressure > 0.0) | (excess > 0.0);
  return volume_strain + real::select(full, rise * c.per_matrix, 0.0);
}

/// Undrained bulk modulus: K + alpha^2 M, Gassmann's; K where gas gives way [stress].
template <class R>
BARRENO_FUNCTION R undrained_bulk(const Constituents& c, const PoresOf<R>& n, const R& bulk) {
  const R biot = 1.0 - bulk * c.per_matrix;
  return bulk + real::select(n.pressure > 0.0, biot * biot / storage_of(c, n, bulk), 0.0);
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
template <class R, class Rock, class Step>
BARRENO_FUNCTION R skeleton_guess(const Rock& rock, const Step& step, const R& bulk) {
  if constexpr (has_poroplastic_fluid<Rock>)
    return skeleton_guess(rock.constituents, step.pores, bulk, step.dv);
  else
    return step.dv;
}
/// Bulk modulus with the fluid that cannot leave [stress].
template <class R, class Rock, class Holder>
BARRENO_FUNCTION R bulk_of(const Rock& rock, const Holder& holder, const R& drained) {
  if constexpr (has_poroplastic_fluid<Rock>)
    return undrained_bulk(rock.constituents, holder.pores, drained);
  else
    return drained;
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
