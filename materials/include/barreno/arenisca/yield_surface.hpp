// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/counters.hpp"
#include "barreno/arenisca/parts/cap_shape.hpp"
#include "barreno/arenisca/parts/shear_limit.hpp"
#include "barreno/arenisca/selection.hpp"
#include "barreno/real.hpp"

#include <type_traits>

namespace barreno::arenisca {

// The meridian of the yield surface, of one point or several (real.hpp): values, derivatives, and
// what lies inside. No other file knows its equation but that of the limit's part.

/// The same cap at every point, or that of points that have their own already.
template <class R, class C>
BARRENO_FUNCTION CapOf<R> same_cap(const CapOf<C>& cap) {
  if constexpr (std::is_same_v<R, C>)
    return cap;
  else
    return {cap.present ? R{} <= 0.0 : none_of<R>(), R{} + cap.X, R{} + cap.kappa, R{}};
}

/// Point of the meridian at I1 = x: limit function, its slope and the cap's factor squared.
template <class R>
struct MeridianOf {
  MaskOf<R> on_cap{};        ///< x < kappa
  R limit{}, limit_slope{};  ///< Ff(x) [stress] and dFf/dx
  R curved{};                ///< what the limit's curvature() takes
  R c{};                     ///< (kappa - x)/(kappa - X) on the cap, else 0
  R inverse_length{};        ///< 1/(kappa - X)
  R cap_squared{};           ///< fc^2; negative beyond the cap's tip, 1 outside the cap's range
  R slope{};                 ///< fc d(Ff fc)/dx, finite everywhere, also at the cap's tip
};

/// Meridian of the yield surface in x = I1 (minus the elastic centre, which is 0 drained) and q =
/// sqrt(J2).
///
///   q = Ff(x) fc(x),  fc^2 = 1 - ((kappa - x)/(kappa - X))^2 for x < kappa
///
/// with Ff the shear limit (parts/shear_limit.hpp). It is convex: Ff is concave and falls, fc is
/// concave and rises, so is their product. CR is the same for all points.
template <class R, class Limit = ShearLimit>
struct SurfaceOf : Limit::template Of<R> {
  double CR = 0.0;  ///< shape of the cap: d(kappa)/dX

  BARRENO_FUNCTION R limit(const R& x) const { return this->limit_at(x).value; }

  /// Points and containment, counted.
  template <class Counter>
  BARRENO_FUNCTION MeridianOf<R> at(const R& x, const CapOf<R>& cap, Counter& count) const {
    count.add();
    return meridian_at(*this, x, cap);
  }
  template <class Counter>
  BARRENO_FUNCTION MaskOf<R> contains(const R& x, const R& J2, const CapOf<R>& cap, Counter& count)
      const;
};
using YieldSurface = SurfaceOf<double>;

/// The surface of points whose limit has its vertex at `peak` [stress].
/// @param p  parameters of the limit and of the cap's shape
template <class Limit, class R, class Parameters>
BARRENO_FUNCTION SurfaceOf<R, Limit> make_surface(const Parameters& p, const R& peak, double CR) {
  SurfaceOf<R, Limit> s;
  static_cast<typename Limit::template Of<R>&>(s) = Limit::make(p, peak);
  s.CR = CR;
  return s;
}

/// The same surface at every point.
template <class R, class Limit>
BARRENO_FUNCTION SurfaceOf<R, Limit> same_surface(const SurfaceOf<double, Limit>& one) {
  SurfaceOf<R, Limit> s;
  static_cast<typename Limit::template Of<R>&>(s) = Limit::template same<R>(one);
  s.CR = one.CR;
  return s;
}
/// The surface of another strength at the same pressure.
template <class R, class Limit>
BARRENO_FUNCTION SurfaceOf<R, Limit> scaled_surface(SurfaceOf<R, Limit> s, const R& gamma) {
  s.scale(gamma);
  return s;
}
/// Its meridian, where that of strength 1 is known.
template <class R>
BARRENO_FUNCTION MeridianOf<R> scaled_meridian(MeridianOf<R> m, const R& gamma) {
  m.limit = gamma * m.limit;
  m.limit_slope = gamma * m.limit_slope;
  m.curved = gamma * m.curved;
  m.slope = gamma * m.slope;
  return m;
}

// @param Surface  SurfaceOf<R, Limit>, or a SurfaceOf<double, Limit> that all points share

/// Branch point of the cap [stress].
template <class R, class Surface>
BARRENO_FUNCTION R branch_point(const Surface& surface, const R& X) {
  return surface.peak - surface.CR * (surface.peak - X);
}

/// Cap of this hydrostatic strength.
BARRENO_FUNCTION Cap cap_with(const YieldSurface& surface, double X) {
  return {true, X, branch_point(surface, X), 0.0};
}

template <class R, class Surface>
BARRENO_FUNCTION MeridianOf<R> meridian_at(
    const Surface& surface, const R& x, const CapOf<R>& cap
) {
  const LimitOf<R> l = surface.limit_at(x);
  MeridianOf<R> m;
  m.curved = l.curved;
  m.limit = l.value;
  m.limit_slope = l.slope;
  m.on_cap = cap.present & (x < cap.kappa);
  m.inverse_length = 1.0 / real::select(cap.present, cap.kappa - cap.X, 1.0);
  m.c = real::select(m.on_cap, (cap.kappa - x) * m.inverse_length, 0.0);
  // 1 - c^2 as a product: no cancellation at the tip, where 1 - c is small.
  m.cap_squared = real::select(m.on_cap, (x - cap.X) * m.inverse_length * (1.0 + m.c), 1.0);
  m.slope = m.limit_slope * m.cap_squared + m.limit * m.c * m.inverse_length;
  return m;
}

/// Derivatives of a meridian point by a parameter that moves x and the cap.
template <class R>
struct MeridianRateOf {
  R limit, cap_squared, slope;
};
/// @param dx, dX  derivatives of x and of the cap's X
template <class R, class Surface>
BARRENO_FUNCTION MeridianRateOf<R> meridian_rate(
    const Surface& surface, const MeridianOf<R>& m, const R& dx, const R& dX_on_cap
) {
  const R dX = real::select(m.on_cap, dX_on_cap, 0.0);
  const R dlength = (surface.CR - 1.0) * dX;
  const R dc =
      real::select(m.on_cap, (surface.CR * dX - dx - m.c * dlength) * m.inverse_length, 0.0);
  const R dcap_squared = -2.0 * m.c * dc;
  const R dlimit = m.limit_slope * dx;
  const R curvature = surface.curvature(m.curved);
  const R dslope =
      curvature * dx * m.cap_squared + m.limit_slope * dcap_squared +
      (dlimit * m.c + m.limit * (dc - m.c * dlength * m.inverse_length)) * m.inverse_length;
  return {dlimit, dcap_squared, dslope};
}

/// The cap's factor fc and the shear strength q = Ff fc of a meridian point, with derivatives.
template <class R>
struct ShearStrengthOf {
  R fc, dfc, q, dq;
};
template <class R>
BARRENO_FUNCTION ShearStrengthOf<R> shear_strength(
    const MeridianOf<R>& m, const MeridianRateOf<R>& d
) {
  ShearStrengthOf<R> s;
  s.fc = real::sqrt(real::larger(m.cap_squared, 0.0));
  s.dfc = real::select(s.fc > 0.0, 0.5 * d.cap_squared / s.fc, 0.0);
  s.q = m.limit * s.fc;
  s.dq = d.limit * s.fc + m.limit * s.dfc;
  return s;
}

/// Elastic if X <= x <= P and J2 <= (Ff fc)^2; from the meridian at x.
template <class R, class Surface>
BARRENO_FUNCTION MaskOf<R> contained(
    const Surface& surface, const R& x, const R& J2, const CapOf<R>& cap, const MeridianOf<R>& m
) {
  return (x <= surface.vertex) & !(cap.present & (x < cap.X)) & (m.limit >= 0.0) &
         (J2 <= m.limit * m.limit * m.cap_squared);
}

/// The same with a bound that spares the limit itself where it decides, as for most elastic points.
/// @param asked where it is asked for
template <class R, class Surface, class Counter = NoCounter>
BARRENO_FUNCTION MaskOf<R> contains(
    const Surface& surface,
    const MaskOf<R>& asked,
    const R& x,
    const R& J2,
    const CapOf<R>& cap,
    Counter&& count = {}
) {
  const MaskOf<R> in_range = asked & (x <= surface.vertex) & !(cap.present & (x < cap.X));
  const MaskOf<R> on_cap = cap.present & (x < cap.kappa);
  const R length = real::select(on_cap, cap.kappa - cap.X, 1.0);
  const R c = real::select(on_cap, (cap.kappa - x) / length, 0.0);
  const R cap_squared = 1.0 - c * c;
  const R bound = surface.lower_bound(x);
  const MaskOf<R> surely =
      in_range & (x <= 0.0) & (bound > 0.0) & (J2 <= bound * bound * cap_squared);
  const MaskOf<R> open = in_range & !surely;
  if (!real::any(open)) return surely;
  count.add();
  const R limit = surface.limit_at(x).value;
  return surely | (open & (limit >= 0.0) & (J2 <= limit * limit * cap_squared));
}

template <class R, class Limit>
template <class Counter>
BARRENO_FUNCTION MaskOf<R> SurfaceOf<R, Limit>::contains(
    const R& x, const R& J2, const CapOf<R>& cap, Counter& count
) const {
  return arenisca::contains(*this, MaskOf<R>(!none_of<R>()), x, J2, cap, count);
}

}  // namespace barreno::arenisca
