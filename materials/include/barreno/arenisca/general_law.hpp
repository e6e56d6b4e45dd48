// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/point_rock.hpp"
#include "barreno/arenisca/points_over_angles.hpp"
#include "barreno/pore_point.hpp"

#include <utility>

namespace barreno::arenisca {

// What the step of points (points_step.hpp) takes of the forms for comparison: moduli, crush curve
// and return of each point by itself. They are written for one point, and cost accordingly.

/// f(i) for each of several points in this state, which is not asked twice for two alike.
template <class R, class F>
BARRENO_FUNCTION R each_state(const R& x, const R& e, const PointRock* points, const F& f) {
  double last = 0.0;
  const auto at = [&](int i) {
    const bool again = i > 0 && real::lane(x, i) == real::lane(x, i - 1) &&
                       real::lane(e, i) == real::lane(e, i - 1) &&
                       points[i].is_alike(points[i - 1]);
    return last = again ? last : f(i);
  };
  return real::each(at, x);
}

/// Elasticity about the centre: that of the drained rock, and of the fluid where it carries
/// pressure.
template <class R>
struct ElasticityAboutCentre {
  const PointRock* points;

  BARRENO_FUNCTION const Elasticity& drained() const { return points[0].rock.elasticity; }
  BARRENO_FUNCTION MaskOf<R> dilated(const R& e) const { return drained().dilated(e); }
  BARRENO_FUNCTION R seen_from(const R& begin, const R& end) const {
    return drained().seen_from(begin, end);
  }
  BARRENO_FUNCTION ModuliOf<R> moduli_at(const R& x, const R& e) const {
    ModuliOf<R> m = drained().moduli_at(x, e);
    if (!points[0].wet()) return m;
    const auto bulk = [&](int i) {
      return points[i].moduli(real::lane(x, i), real::lane(e, i)).bulk;
    };
    m.bulk = each_state(x, e, points, bulk);
    return m;
  }
  BARRENO_FUNCTION ElasticStateOf<R> state_at(const R& x, const R& e) const {
    ElasticStateOf<R> n = drained().state_at(x, e);
    if (points[0].wet()) n.moduli = moduli_at(x, e);
    return n;
  }
  BARRENO_FUNCTION ModuliOf<R> moduli_midway(const ElasticStateOf<R>& n, const R& change) const {
    if (!points[0].wet()) return drained().moduli_midway(n, change);
    return moduli_at(R(n.x + 0.5 * change), n.evp);
  }
  BARRENO_FUNCTION ModuliOf<R> moduli_after(
      const MaskOf<R>& asked, const ElasticStateOf<R>& n, const R& x_end
  ) const {
    if (!points[0].wet()) return drained().moduli_after(asked, n, x_end);
    return moduli_at(x_end, n.evp);
  }
};

/// Hydrostatic strength seen from the centre, with its slope by differences of fourth order.
template <class R>
struct CrushCurveAboutCentre {
  const PointRock* points;

  BARRENO_FUNCTION const CrushCurve& drained() const { return points[0].rock.crush; }
  BARRENO_FUNCTION bool porous() const { return drained().porous(); }
  BARRENO_FUNCTION double last_open() const { return drained().last_open(); }
  BARRENO_FUNCTION double closed() const { return drained().closed(); }
  BARRENO_FUNCTION CrushedOf<R> at(const R& e) const {
    CrushedOf<R> c = drained().at(e);
    if (!points[0].wet()) return c;
    // Small against the distance to closed pores, on which the curve's bends depend.
    constexpr double part = 1e-3;
    const R width = part * (e + drained().p3);
    const MaskOf<R> inner = c.open & (e - 2.0 * width > drained().last_open());
    const R dry = c.X;
    c.X = strength(c.open, e);
    const R near = strength(inner, R(e + width)) - strength(inner, R(e - width));
    const R far = strength(inner, R(e + 2.0 * width)) - strength(inner, R(e - 2.0 * width));
    const R slope = (8.0 * near - far) / (12.0 * real::select(inner, width, 1.0));
    c.slope = real::select(inner, slope, c.slope * (c.X / dry));
    return c;
  }

private:
  BARRENO_FUNCTION R strength(const MaskOf<R>& asked, const R& e) const {
    const auto one = [&](int i) {
      return real::lane(asked, i) ? points[i].strength(real::lane(e, i)) : 0.0;
    };
    return each_state(e, e, points, one);
  }
};
/// Its strength need not be concave.
template <class R>
inline constexpr bool is_concave<CrushCurveAboutCentre<R>> = false;

/// Pieces of the forms for comparison.
template <class R>
struct GeneralPiecesOf : AngledPiecesOf<R, Rock> {
  static constexpr bool wet = true, about_centre = true;

  PointRock points[real::count_of<R>];
  ElasticityAboutCentre<R> elasticity{points};
  CrushCurveAboutCentre<R> crush{points};

  BARRENO_FUNCTION GeneralPiecesOf(const GeneralRock& rock, const R& coherence, const R& fluid_mass)
      : GeneralPiecesOf(
            rock, coherence, fluid_mass, std::make_integer_sequence<int, real::count_of<R>>{}
        ) {}
  GeneralPiecesOf(const GeneralPiecesOf&) = delete;
  GeneralPiecesOf& operator=(const GeneralPiecesOf&) = delete;

  /// Whether returns are those for one point.
  BARRENO_FUNCTION bool returns_alone() const {
    return this->bisection || points[0].rock.plastic_backstress;
  }
  /// I1 at the elastic centre [stress].
  BARRENO_FUNCTION R zeta(const R& e) const {
    if (!points[0].wet()) return R{};
    const auto one = [&](int i) { return points[i].zeta(real::lane(e, i)); };
    return each_state(e, e, points, one);
  }
  /// e at which an elastic way from `begin` has this change of x, I1 fixed by the strain: the
  /// published backstress moves while plastic strain is taken off.
  BARRENO_FUNCTION R strain_for(const R& begin, const R& change, const R& triple_bulk) const {
    const R straight = begin + change / triple_bulk;
    if (!points[0].rock.plastic_backstress) return straight;
    const auto one = [&](int i) {
      const double e = real::lane(begin, i), K3 = real::lane(triple_bulk, i);
      const double wanted = real::lane(change, i), zeta = points[i].zeta(e);
      const auto left = [&](double at) {
        return K3 * (at - e) + points[i].zeta(at) - zeta - wanted;
      };
      const double far = real::lane(straight, i), beyond = left(far);
      if (!(beyond * wanted > 0.0)) return far;
      return find_root(left, {e, -wanted}, {far, beyond}, 1e-15 * std::fabs(far - e), 0.0);
    };
    return real::each(one, begin);
  }

private:
  template <int... i>
  BARRENO_FUNCTION GeneralPiecesOf(
      const GeneralRock& rock,
      const R& coherence,
      const R& fluid_mass,
      std::integer_sequence<int, i...> /*all*/
  )
      : AngledPiecesOf<R, Rock>(rock, coherence),
        points{PointRock(rock, real::lane(coherence, i), real::lane(fluid_mass, i))...} {}
};
template <class R>
struct RockFor<R, GeneralRock> {
  using type = GeneralPiecesOf<R>;
};

template <class R>
BARRENO_FUNCTION Trial trial_of(const TrialOf<R>& t, int i) {
  const auto at = [&](const R& x) { return real::lane(x, i); };
  const Cap cap{real::lane(t.cap.present, i), at(t.cap.X), at(t.cap.kappa), at(t.cap.slope)};
  return {at(t.x), at(t.q), at(t.metric), at(t.triple_bulk), at(t.evp), cap};
}
template <class R>
BARRENO_FUNCTION Sym3 one_tensor(const Sym3Of<R>& s, int i) {
  const auto at = [&](const R& x) { return real::lane(x, i); };
  return {at(s.xx), at(s.yy), at(s.zz), at(s.xy), at(s.yz), at(s.zx)};
}

/// The return of one point, and the turn of its shear stress.
struct TurnedOne {
  Returned end;
  double turn;
};
BARRENO_FUNCTION TurnedOne return_one(const PointRock& point, const Sym3& s, const Trial& trial) {
  NoCounter none;
  const Lode& lode = point.rock.lode;
  if (!lode.active() || trial.q == 0.0)
    return {return_in_half_plane(point, point.surface, trial, none), 0.0};
  const double theta = lode_angle(s);
  ReturnOverAngles<NoCounter> over_angles{point, trial, theta, none};
  const double angle = over_angles.solve();
  return {over_angles.at(angle, lode.at(angle).gamma), angle - theta};
}

/// Returns point by point: by the paper's bisection, and with its backstress.
/// @param s  trial shear stress, trial.q long
template <class R>
BARRENO_FUNCTION ReturnedShear<R, GeneralRock> return_alone(
    const GeneralPiecesOf<R>& rock,
    const DeviatorOf<R>& s,
    const TrialOf<R>& trial,
    const MaskOf<R>& outside
) {
  ReturnedOf<R> r{trial.x, trial.q, trial.evp, {}, none_of<R>()};
  R cosine = R{} + 1.0, sine{};
  for (int i = 0; i < real::count_of<R>; ++i) {
    if (!real::lane(outside, i)) continue;
    const TurnedOne one = return_one(rock.points[i], one_tensor(s.tensor, i), trial_of(trial, i));
    real::set_lane(r.x, i, one.end.x);
    real::set_lane(r.q, i, one.end.q);
    real::set_lane(r.evp, i, one.end.evp);
    real::set_lane(cosine, i, std::cos(one.turn));
    real::set_lane(sine, i, std::sin(one.turn));
  }
  r.cap = cap_of(rock, r.evp);
  r.refused = outside & !real::is_finite(R(r.x + r.q + r.evp));
  const AngleOf<R> angle = angle_of(rock.lode, s);
  cosine = real::select(angle.turnable, cosine, 1.0);
  return {r, R(r.q * cosine) * angle.along + R(r.q * sine) * angle.across};
}

/// What a host is told of the pores in a state.
template <class R, class History>
BARRENO_FUNCTION void tell_pores(
    const GeneralPiecesOf<R>& rock, const MaskOf<R>& choice, const R& x, History& h
) {
  const R& e = h.plastic_volume_strain;
  const auto pressure = [&](int i) {
    const double in_pores = rock.points[i].pore_pressure(real::lane(x, i), real::lane(e, i));
    return pressure_of_fluid(in_pores, real::lane(h.fluid_mass_ratio, i));
  };
  const auto porosity = [&](int i) { return rock.points[i].porosity(real::lane(e, i)); };
  const auto told = [&](const auto& one) { return each_state(x, e, rock.points, one); };
  h.pore_pressure = real::select(choice, told(pressure), h.pore_pressure);
  h.porosity = real::select(choice, told(porosity), h.porosity);
}

}  // namespace barreno::arenisca
