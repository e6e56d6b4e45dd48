// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points_return.hpp"
#include "barreno/arenisca/points_state.hpp"
#include "barreno/arenisca/points_turned_return.hpp"

#include <type_traits>

namespace barreno::arenisca {

// Return of the shear stress: straight back, or where the strength depends on the Lode angle, to
// the closest point of the octahedral plane.

/// What a return reads of a rock, with the surface of one half-plane.
template <class Crush, class Surface>
struct HalfPlane {
  const Crush& crush;
  double stress_floor;
  Surface surface;
};

/// Return within the half-plane after a turn of the trial state's angle.
/// @param at_trial the meridian of triaxial compression at the trial state
template <class R, class Rock>
BARRENO_FUNCTION ReturnedOf<R> return_after_turn(
    const Rock& rock,
    const TrialOf<R>& trial,
    const MaskOf<R>& outside,
    const MeridianOf<R>& at_trial,
    const R& guess,
    const TurnedAngle<R>& to
) {
  const auto surface = scaled_surface(rock.surface, to.strength.gamma);
  const HalfPlane<decltype(rock.crush), decltype(surface)> there = {
      rock.crush, rock.stress_floor, surface};
  TrialOf<R> part = trial;
  part.q = trial.q * to.cosine;
  const MeridianOf<R> m = scaled_meridian(at_trial, to.strength.gamma);
  const MaskOf<R> inside = contained(there.surface, part.x, R(part.q * part.q), part.cap, m);
  ReturnedOf<R> r = return_points(there, part, MaskOf<R>(outside & !inside), m, guess);
  r.x = real::select(inside, part.x, r.x);
  r.q = real::select(inside, part.q, r.q);
  r.evp = real::select(inside, part.evp, r.evp);
  r.refused = r.refused & !inside;
  return r;
}

/// A turn and what it leaves of the condition of the closest point,
///
///   Gamma'/Gamma (q - q_tr cos d) + q_tr sin d = 0,
///
/// with q the return within the half-plane after the turn d; see ReturnOverAngles.
template <class R>
struct TriedTurn {
  R half_tangent{};
  TurnedAngle<R> angle;
  ReturnedOf<R> returned;
  R residual{};
};
template <class R>
BARRENO_FUNCTION void measure_residual(const TrialOf<R>& trial, TriedTurn<R>& t) {
  const R bend = t.angle.strength.slope / t.angle.strength.gamma;
  t.residual = bend * (t.returned.q - trial.q * t.angle.cosine) + trial.q * t.angle.sine;
}

/// Secant method in a bracket from the trial state's own angle to the axis to whose side the
/// closest point lies; the axis itself where the surface has an edge there.
/// @param open where a turn is asked for
/// @param[in,out] at no turn; the one that is found
template <class R, class Rock>
BARRENO_FUNCTION void find_turn(
    const Rock& rock,
    const AngleOf<R>& angle,
    const TrialOf<R>& trial,
    const MeridianOf<R>& at_trial,
    MaskOf<R> open,
    TriedTurn<R>& at
) {
  constexpr int max_iterations = 50;
  constexpr double close_enough = 1e-11;
  const MaskOf<R> down = at.residual > 0.0;
  const TurnRange<R> range = turns_to_axes(angle);
  const R axis = real::select(down, range.low, range.high);
  R near{}, far = axis;  // the condition has the first sign at `near`
  const R slope = 2.0 * (trial.q + angle.bend * angle.bend * at.returned.q);
  R next = -at.residual / slope;
  next = real::select(real::abs(next) < real::abs(axis), next, axis);
  for (int i = 0; i < max_iterations && real::any(open); ++i) {
    TriedTurn<R> tried;
    tried.half_tangent = next;
    tried.angle = turned_by(rock.lode, angle, next);
    const R guess = at.returned.evp - trial.evp;
    tried.returned = return_after_turn(rock, trial, open, at_trial, guess, tried.angle);
    measure_residual(trial, tried);
    const MaskOf<R> same = (down & (tried.residual > 0.0)) | ((!down) & (tried.residual < 0.0));
    near = real::select(same, next, near);
    far = real::select(same, far, next);
    const R rise = tried.residual - at.residual;
    const R step =
        -tried.residual * (next - at.half_tangent) / real::select(rise != 0.0, rise, HUGE_VAL);
    assign_where(open, tried.returned, at.returned);
    at.half_tangent = real::select(open, next, at.half_tangent);
    at.angle.cosine = real::select(open, tried.angle.cosine, at.angle.cosine);
    at.angle.sine = real::select(open, tried.angle.sine, at.angle.sine);
    at.residual = real::select(open, tried.residual, at.residual);
    const MaskOf<R> done = (real::abs(step) <= close_enough) | (same & (next == axis)) |
                           (real::abs(far - near) <= close_enough);
    open = open & !done;
    const R secant = next + step;
    const R low = smaller_of(near, far), high = larger_of(near, far);
    const MaskOf<R> sound = (secant > low) & (secant < high);
    // An axis that was not tried yet may be the answer itself.
    const MaskOf<R> beyond = (far == axis) & !(real::abs(secant) < real::abs(axis));
    next = real::select(sound, secant, real::select(beyond, axis, 0.5 * (near + far)));
  }
}

/// The closest point over the Lode angle where the way to it is not smooth: turn by turn, each with
/// a return within its half-plane.
template <class R, class Rock>
BARRENO_FUNCTION TriedTurn<R> return_turn_by_turn(
    const Rock& rock,
    const AngleOf<R>& angle,
    const TrialOf<R>& trial,
    const MaskOf<R>& outside,
    const MeridianOf<R>& at_trial,
    const R& guess
) {
  constexpr double nothing = 1e-13;
  TriedTurn<R> at;
  at.angle = {R{} + 1.0, R{}, {angle.gamma, angle.gamma * angle.bend}};
  at.returned = return_after_turn(rock, trial, outside, at_trial, guess, at.angle);
  measure_residual(trial, at);
  const MaskOf<R> open = outside & angle.turnable & (at.returned.q > 0.0) &
                         (real::abs(at.residual) > nothing * trial.q) & !at.returned.refused;
  if (real::any(open)) find_turn(rock, angle, trial, at_trial, open, at);
  return at;
}

/// Where a trial shear stress comes back to.
template <class R, class Law>
struct ReturnedShear {
  ReturnedOf<R> point;
  ShearIn<R, Law> shear;
};

/// What a return is told to begin with: a gain of evp, infinity where there is none, and a turn if
/// the law lets stress turn.
template <class R, class Law>
using GuessIn = std::conditional_t<Law::angled, TurnGuess<R>, R>;
template <class R, class Law>
BARRENO_FUNCTION GuessIn<R, Law> no_guess() {
  if constexpr (Law::angled)
    return {R{} + HUGE_VAL, R{}, false, Law::about_centre ? patient_turn : rough_turn};
  else
    return R{} + HUGE_VAL;
}
/// From where another return led to, close by.
/// @param p  the prediction, with the angle that the return starts from
template <class R, class Law>
BARRENO_FUNCTION GuessIn<R, Law> guess_from(
    const PredictionOf<R, Law>& p, const ShearIn<R, Law>& end, const R& gain
) {
  if constexpr (Law::angled) {
    const R along = dot(end, p.angle.along), across = dot(end, p.angle.across);
    const R size = real::sqrt(R(along * along + across * across));
    const MaskOf<R> ahead = along > 0.0;
    return {
        gain,
        real::select(ahead, across / real::select(ahead, size + along, 1.0), 0.0),
        true,
        Law::about_centre ? patient_turn : exact_turn};
  } else {
    return gain;
  }
}

/// Return of a trial shear stress.
/// @param p       the prediction; where the strength depends on the angle, with that of `s`
/// @param s       trial shear stress, trial.q long
template <class R, class Law>
BARRENO_FUNCTION ReturnedShear<R, Law> return_shear(
    const RockOf<R, Law>& rock,
    const PredictionOf<R, Law>& p,
    const ShearIn<R, Law>& s,
    const TrialOf<R>& trial,
    const MaskOf<R>& outside,
    const MeridianOf<R>& at_trial,
    const GuessIn<R, Law>& guess
) {
  if constexpr (Law::about_centre)
    if (rock.returns_alone()) return return_alone(rock, s, trial, outside);
  if constexpr (Law::angled) {
    const AngleOf<R>& angle = p.angle;
    TurnedReturn<R> r = return_with_turn(rock, angle, trial, outside, at_trial, guess);
    const MaskOf<R> rest = outside & !r.found;
    if (real::any(rest)) {
      const TriedTurn<R> at = return_turn_by_turn(rock, angle, trial, rest, at_trial, guess.gain);
      assign_where(rest, at.returned, r.point);
      r.half_tangent = real::select(rest, at.half_tangent, r.half_tangent);
    }
    const R inverse = 1.0 / (1.0 + r.half_tangent * r.half_tangent);
    const R cosine = (1.0 - r.half_tangent * r.half_tangent) * inverse;
    const R sine = 2.0 * r.half_tangent * inverse;
    const R q = r.point.q;
    return {r.point, R(q * cosine) * angle.along + R(q * sine) * angle.across};
  } else {
    const ReturnedOf<R> r = return_points(rock, trial, outside, at_trial, guess);
    return {r, lengthened(s, trial.q, r.q)};
  }
}

}  // namespace barreno::arenisca
