// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points_shear.hpp"
#include "barreno/arenisca/rock.hpp"
#include "barreno/real.hpp"

namespace barreno::arenisca {

// The drained rock for one point or several at once (real.hpp): what elasticity.hpp,
// crush_curve.hpp and yield_surface.hpp give for one point, with the derivatives that Newton's
// method asks for.

/// Size of a stress: sqrt(sigma : sigma).
template <class R>
BARRENO_FUNCTION R size_of_stress(const R& x, const R& J2) {
  return real::sqrt(R(x * x * (1.0 / 3.0) + 2.0 * J2));
}
template <class R>
BARRENO_FUNCTION R smaller_of(const R& a, const R& b) {
  return real::select(a < b, a, b);
}
template <class R>
BARRENO_FUNCTION R larger_of(const R& a, const R& b) {
  return real::select(a > b, a, b);
}
template <class R>
BARRENO_FUNCTION MaskOf<R> none_of() {
  return R{} > 0.0;
}

/// Cap of the surface and the slope of the crush curve there; X = -infinity is never stored: where
/// not `present`, X and kappa mean nothing.
template <class R>
struct CapOf {
  MaskOf<R> present;
  R X{}, kappa{};
  R slope{};  ///< dX/d(evp) [stress]
};

template <class R, class Law>
BARRENO_FUNCTION CapOf<R> cap_of(const Law& rock, const R& evp) {
  const CrushCurve& crush = rock.crush;
  CapOf<R> cap{none_of<R>()};
  if (crush.p3 == 0.0) return cap;
  const CrushRates& rates = rock.rates;
  const R open_fraction = 1.0 + rates.per_p3 * evp;
  cap.present = open_fraction > CrushCurve::closed_fraction;
  const MaskOf<R> dilated = evp > 0.0;
  const R argument =
      real::select(dilated, 1.0 + evp, real::select(cap.present, open_fraction, 1.0));
  const R logarithm = real::log(argument);
  cap.X = crush.p0 + rates.per_p1 * logarithm;
  cap.slope = rates.at_start / argument;
  if (real::any(dilated)) {
    const R ratio =
        real::larger(real::exp(R(rates.power * logarithm)), CrushCurve::retraction_limit);
    cap.X = real::select(dilated, crush.p0 * ratio, cap.X);
    cap.slope = real::select(dilated, ratio * cap.slope, cap.slope);
  }
  cap.kappa = rock.surface.peak - rock.surface.CR * (rock.surface.peak - cap.X);
  return cap;
}
/// The same cap at every point.
template <class R>
BARRENO_FUNCTION CapOf<R> same_cap(const Cap& cap) {
  return {cap.present ? R{} <= 0.0 : none_of<R>(), R{} + cap.X, R{} + cap.kappa, R{}};
}
/// Points that have their own already.
template <class R>
BARRENO_FUNCTION CapOf<R> same_cap(const CapOf<R>& cap) {
  return cap;
}

/// Point of the meridian at I1 = x, see MeridianPoint.
template <class R>
struct MeridianOf {
  MaskOf<R> on_cap;  ///< x < kappa
  R limit, limit_slope, curved;
  R c;               ///< (kappa - x)/(kappa - X) on the cap, else 0
  R inverse_length;  ///< 1/(kappa - X)
  R cap_squared, slope;
};

template <class R, class Surface>
BARRENO_FUNCTION MeridianOf<R> meridian_at(
    const Surface& surface, const R& x, const CapOf<R>& cap
) {
  MeridianOf<R> m;
  m.curved = surface.linear() ? R{} : R(surface.a3 * real::exp(R(surface.a2 * x)));
  m.limit = surface.a1 - m.curved - surface.a4 * x;
  m.limit_slope = -surface.a2 * m.curved - surface.a4;
  m.on_cap = cap.present & (x < cap.kappa);
  m.inverse_length = 1.0 / real::select(cap.present, cap.kappa - cap.X, 1.0);
  m.c = real::select(m.on_cap, (cap.kappa - x) * m.inverse_length, 0.0);
  m.cap_squared = real::select(m.on_cap, (x - cap.X) * m.inverse_length * (1.0 + m.c), 1.0);
  m.slope = m.limit_slope * m.cap_squared + m.limit * m.c * m.inverse_length;
  return m;
}

/// YieldSurface::contains() from the meridian at x.
template <class R, class Surface>
BARRENO_FUNCTION MaskOf<R> contained(
    const Surface& surface, const R& x, const R& J2, const CapOf<R>& cap, const MeridianOf<R>& m
) {
  return (x <= surface.vertex) & !(cap.present & (x < cap.X)) & (m.limit >= 0.0) &
         (J2 <= m.limit * m.limit * m.cap_squared);
}

/// YieldSurface::contains() with its bound that spares the exponential where it decides.
template <class R, class Surface>
BARRENO_FUNCTION MaskOf<R> contains(
    const Surface& surface, const MaskOf<R>& asked, const R& x, const R& J2, const CapOf<R>& cap
) {
  const MaskOf<R> in_range = asked & (x <= surface.vertex) & !(cap.present & (x < cap.X));
  const MaskOf<R> on_cap = cap.present & (x < cap.kappa);
  const R length = real::select(on_cap, cap.kappa - cap.X, 1.0);
  const R c = real::select(on_cap, (cap.kappa - x) / length, 0.0);
  const R cap_squared = 1.0 - c * c;
  const R y = surface.a2 * x;
  const R bound = surface.a1 - surface.a3 / (1.0 - y + 0.5 * y * y) - surface.a4 * x;
  const MaskOf<R> surely =
      in_range & (x <= 0.0) & (bound > 0.0) & (J2 <= bound * bound * cap_squared);
  const MaskOf<R> open = in_range & !surely;
  if (!real::any(open)) return surely;
  const R curved = surface.linear() ? R{} : R(surface.a3 * real::exp(y));
  const R limit = surface.a1 - curved - surface.a4 * x;
  return surely | (open & (limit >= 0.0) & (J2 <= limit * limit * cap_squared));
}

template <class R>
struct ModuliOf {
  R bulk{}, shear{};
};
template <class R>
BARRENO_FUNCTION ModuliOf<R> moduli_of(
    const Elasticity& e, const R& pressure_value, const R& coupling
) {
  const R bulk = e.B0 + e.B1 * pressure_value - coupling;
  if (!e.variable_ratio()) return {bulk, R{} + e.G0};
  const R nu = e.G1 + e.G2 * pressure_value;
  return {bulk, 1.5 * bulk * (1.0 - 2.0 * nu) / (1.0 + nu)};
}

/// exp(B2/I1) and its derivatives by I1, see Elasticity::PressureTerm.
template <class R>
struct PressureTermOf {
  R value{}, slope{}, curvature{};
};
template <class R>
BARRENO_FUNCTION PressureTermOf<R> pressure_term_of(const Elasticity& e, const R& x, const R& evp) {
  const MaskOf<R> pressed = (x < 0.0) & (evp <= Elasticity::at_jump);
  if ((e.B1 == 0.0 && !e.variable_ratio()) || !real::any(pressed)) return {};
  const R inverse = 1.0 / real::select(pressed, x, -1.0);
  const R ratio = e.B2 * inverse;
  const R value = real::select(pressed, real::exp(ratio), 0.0);
  const R slope = -ratio * inverse * value;
  return {value, slope, -slope * inverse * (ratio + 2.0)};
}
template <class R>
BARRENO_FUNCTION R coupling_of(const Elasticity& e, const R& x, const R& evp) {
  if (e.B3 == 0.0) return R{};
  const MaskOf<R> coupled = (x < 0.0) & (evp < 0.0);
  if (!real::any(coupled)) return R{};
  return real::select(coupled, e.B3 * real::exp(R(e.B4 / real::select(coupled, evp, -1.0))), 0.0);
}
template <class R>
BARRENO_FUNCTION ModuliOf<R> moduli_of_state(const Elasticity& e, const R& x, const R& evp) {
  return moduli_of(e, pressure_term_of(e, x, evp).value, coupling_of(e, x, evp));
}

}  // namespace barreno::arenisca
