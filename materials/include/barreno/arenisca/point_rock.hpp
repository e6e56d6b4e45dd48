// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/bisection.hpp"
#include "barreno/arenisca/centre_path.hpp"
#include "barreno/arenisca/points_angle.hpp"
#include "barreno/arenisca/pore_fluid.hpp"
#include "barreno/arenisca/published_fluid.hpp"

#include <cmath>

namespace barreno::arenisca {

/// What points of the forms for comparison share: pore fluid in a published form, the paper's
/// return, with the other features of a card. Where there is fluid, x = I1 - zeta and e are counted
/// from the elastic centre (e is the volumetric plastic strain where the published backstress is
/// asked for).
struct GeneralRock : AngledRock<Rock> {
  static constexpr bool wet = true, about_centre = true;

  PoreFluid fluid;
  PublishedFluid published;         ///< instead of `fluid` where it is present
  bool plastic_backstress = false;  ///< the published backstress: zeta at the plastic strain
};

/// The rock of one point: coherence and mass of fluid are its own. Serves the returns as crush
/// curve.
struct PointRock {
  const GeneralRock& rock;
  YieldSurface surface;
  double coherence, mass;  ///< strength at the vertex, and mass of fluid, over those of the card
  PoreFluid fluid;         ///< as in virgin rock with that mass of it: e counts from there
  double mu;               ///< 1, or less where that rock is not full
  double density = 1.0;    ///< mass of fluid over mu
  double p3;               ///< -ln(1 - porosity), as the returns ask for it
  double filling = 0.0;    ///< e at which the fluid just fills the pores

  BARRENO_FUNCTION PointRock(const GeneralRock& r, double strength_ratio, double fluid_mass_ratio)
      : rock(r),
        surface(make_surface<ShearLimit>(
            r.strength, strength_ratio * ShearLimit::peak(r.strength), r.surface.CR
        )),
        coherence(strength_ratio),
        mass(fluid_mass_ratio),
        fluid(r.fluid),
        mu(fluid_mass_ratio),
        p3(r.crush.p3) {
    if (!r.fluid.present()) return;
    if (!r.published.present() && !r.plastic_backstress) {
      const PoreFluid::Held held = r.fluid.holding(fluid_mass_ratio);
      fluid.initial_pressure = held.pressure;
      mu = held.mu;
      density = held.density;
    }
    filling = fluid.filling_strain(mu);
  }

  BARRENO_FUNCTION bool is_alike(const PointRock& other) const {
    return mass == other.mass && coherence == other.coherence;
  }
  /// Whether the fluid changes anything.
  BARRENO_FUNCTION bool wet() const { return rock.published.present() || fluid.present(); }
  BARRENO_FUNCTION bool has_cap(double e) const { return rock.crush.has_cap(e); }
  BARRENO_FUNCTION double last_open() const { return rock.crush.last_open(); }
  BARRENO_FUNCTION double closed() const { return rock.crush.closed(); }
  BARRENO_FUNCTION double strength(double e) const {
    const double dry = rock.crush.strength(e);
    if (rock.published.present()) return rock.published.strength(rock.elasticity, dry, e);
    if (!fluid.present()) return dry;
    return saturated_strength(fluid, rock.elasticity, at_centre(e), dry, e);
  }
  BARRENO_FUNCTION Cap cap_at(double e) const {
    return has_cap(e) ? cap_with(surface, strength(e)) : Cap{};
  }
  BARRENO_FUNCTION FluidState at_centre(double e) const {
    return fluid_at(fluid, rock.elasticity, e, mu, filling);
  }
  /// I1 at the elastic centre [stress].
  BARRENO_FUNCTION double zeta(double e) const {
    if (rock.published.present()) return rock.published.zeta(e);
    if (!fluid.present()) return 0.0;
    return e > filling ? 0.0 : -3.0 * fluid.centre_pressure(e, mu);
  }
  BARRENO_FUNCTION Moduli moduli(double x, double e) const {
    if (rock.published.present()) return rock.published.moduli(rock.elasticity, x, e);
    if (!fluid.present()) return rock.elasticity.moduli_at(x, e);
    return saturated_moduli(fluid, rock.elasticity, at_centre(e), x, e);
  }
  BARRENO_FUNCTION double porosity(double e) const {
    if (p3 == 0.0) return 0.0;
    if (!fluid.present()) return larger(0.0, -std::expm1(-p3 - e));
    const double pressure = e > filling ? 0.0 : fluid.centre_pressure(e, mu);
    return fluid.porosity_at(e, mu, pressure);
  }
  /// Pressure of the fluid, not that at the centre: elastic compression about it raises it by
  /// Skempton's B of every state on the way [stress].
  BARRENO_FUNCTION double pore_pressure(double x, double e) const {
    if (!fluid.present()) return 0.0;
    return centre_path(fluid, rock.elasticity, at_centre(e), x, e).pressure;
  }
};

/// The published backstress: zeta follows the plastic strain, so that the surface moves under a
/// trial point that stays. Fixed-surface closest points within one scalar equation for d(evp).
template <class Counter>
struct PublishedReturn {
  const PointRock& point;
  const YieldSurface& surface;
  const Trial& trial;
  double zeta;  ///< at the start
  Counter& count;

  struct At {
    Returned end;
    double devp;  ///< what the return gives
  };
  BARRENO_FUNCTION At at(double devp) const {
    const double evp = trial.evp + devp;
    const double seen = trial.x - (point.zeta(evp) - zeta);
    const Cap cap = point.has_cap(evp) ? cap_with(surface, point.strength(evp)) : Cap{};
    if (surface.contains(seen, trial.q * trial.q, cap, count)) {
      return {{seen, trial.q, evp}, 0.0};
    }
    const Trial moved{seen, trial.q, trial.metric, trial.triple_bulk, evp, cap};
    const Returned r = return_without_hardening(surface, moved, cap, count);
    return {{r.x, r.q, evp}, (seen - r.x) / trial.triple_bulk};
  }
  BARRENO_FUNCTION double operator()(double devp) const { return devp - at(devp).devp; }

  BARRENO_FUNCTION Returned solve() const {
    const double start = at(0.0).devp;
    if (start == 0.0) return at(0.0).end;
    double far = start;
    constexpr int max_expansions = 60;
    for (int i = 0; i < max_expansions; ++i) {
      const double residual = (*this)(far);
      if (residual == 0.0) return at(far).end;
      if (residual * start > 0.0) {
        const double devp =
            find_root(*this, {0.0, -start}, {far, residual}, 1e-15 * std::fabs(far), 0.0);
        return at(devp).end;
      }
      far *= 1.5;
    }
    return at(far).end;
  }
};

/// Return at a fixed Lode angle: the meridian of that half-plane, and the trial's part in it.
template <class Counter>
BARRENO_FUNCTION Returned return_in_half_plane(
    const PointRock& point, const YieldSurface& surface, const Trial& trial, Counter& count
) {
  if (surface.contains(trial.x, trial.q * trial.q, trial.cap, count))
    return {trial.x, trial.q, trial.evp};
  if (point.rock.plastic_backstress) {
    const double zeta = point.zeta(trial.evp);
    return PublishedReturn<Counter>{point, surface, trial, zeta, count}.solve();
  }
  return return_bisection(surface, point, trial, count);
}

/// Closest point in three dimensions: where the distance along the Lode angle has its minimum too.
///
///   d(distance^2)/d theta = 0:  Gamma'/Gamma q (q - q_tr cos d) + q q_tr sin d = 0,  d = theta -
///   theta_tr
///
/// with (x, q) the return within the half-plane of theta. The elastic set is convex and isotropic,
/// so the minimum lies on the side to which the strength rises and there is one.
template <class Counter>
struct ReturnOverAngles {
  const PointRock& point;
  const Trial& trial;  ///< with the trial's full q
  double theta;        ///< of the trial
  Counter& count;

  BARRENO_FUNCTION Returned at(double angle, double gamma) const {
    Trial part = trial;
    part.q = trial.q * std::cos(angle - theta);
    return return_in_half_plane(point, scaled_surface(point.surface, gamma), part, count);
  }
  BARRENO_FUNCTION double operator()(double angle) const {
    const Lode::Value g = point.rock.lode.at(angle);
    const Returned r = at(angle, g.gamma);
    const double d = angle - theta;
    return g.slope / g.gamma * (r.q - trial.q * std::cos(d)) + trial.q * std::sin(d);
  }
  /// The angle of the closest point.
  BARRENO_FUNCTION double solve() const {
    const double here = (*this)(theta);
    if (here == 0.0) return theta;
    const double end = here > 0.0 ? 0.0 : Lode::third_turn;
    if (end == theta) return theta;
    const double there = (*this)(end);
    if ((there > 0.0) == (here > 0.0)) return end;
    return find_root(*this, {theta, here}, {end, there}, 1e-15, 1e-15 * trial.q);
  }
};

}  // namespace barreno::arenisca
