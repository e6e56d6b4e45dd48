// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/arenisca_points.hpp"
#include "materials/scalar_arenisca.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

/// The fast return of Arenisca against the bisection of the paper, on the same substeps.
namespace barreno::test {

struct SolverDifference {
  double stress = 0.0;          ///< relative to the larger of strength and trial stress
  double plastic_strain = 0.0;  ///< of the volumetric one
  bool flows = false, sound = false;
  Sym3 end;  ///< stress
  double evp = 0.0;
};

/// Both solvers for one parameter set; the substeps are those that the fast one chooses.
class TwoSolvers {
public:
  explicit TwoSolvers(const Arenisca::Parameters& p)
      : fast_(with_solver(p, 0)), slow_(with_solver(p, 1)) {}
  const Arenisca& model() const { return fast_; }

  SolverDifference compare(const RockPoint& point) {
    record_->count = 0;
    SolverDifference d;
    d.end = point.stress;
    Sym3 other = point.stress;
    Arenisca::History history = point.history, other_history = point.history;
    const Outcome one = fast_.update_counted(point.increment, d.end, history, *record_);
    arenisca::SubstepReplay replay{*record_};
    const Outcome two = slow_.update_counted(point.increment, other, other_history, replay);
    const double bulk = fast_.rock().elasticity.published_bound().bulk;
    const double trial = norm(point.stress) + 3.0 * bulk * norm(point.increment.strain);
    d.sound = !one.failed() && !two.failed();
    d.flows = one.plastic_work > 0.0;
    d.stress = norm(d.end - other) / std::max(trial, fast_.rock().stress_floor);
    d.evp = history.plastic_volume_strain;
    d.plastic_strain = std::fabs(d.evp - other_history.plastic_volume_strain);
    return d;
  }

private:
  static ScalarArenisca with_solver(Arenisca::Parameters p, int solver) {
    p.return_solver = solver;
    return {p, 1.0};
  }

  ScalarArenisca fast_, slow_;
  std::unique_ptr<arenisca::SubstepRecord> record_ = std::make_unique<arenisca::SubstepRecord>();
};

/// How many updates that flow ended at the special places of the surface.
struct Places {
  long vertex = 0, tip = 0, branch = 0, hydrostat = 0, closed = 0, dilating = 0, compacting = 0;

  void add(const arenisca::Rock& rock, const RockPoint& point, const SolverDifference& d) {
    constexpr double near = 1e-6;
    const double x = trace(d.end), evp = point.history.plastic_volume_strain;
    const arenisca::Cap cap = rock.cap_at(d.evp);
    const double size = std::max(norm(d.end), rock.stress_floor);
    vertex += x >= rock.surface.vertex ? 1 : 0;
    hydrostat += norm(deviator(d.end)) <= near * size ? 1 : 0;
    closed += rock.crush.p3 > 0.0 && !cap.present ? 1 : 0;
    if (!cap.present) return;
    tip += std::fabs(x - cap.X) <= near * size ? 1 : 0;
    branch += std::fabs(x - cap.kappa) <= 1e-3 * size ? 1 : 0;
    dilating += x < cap.kappa && d.evp > evp ? 1 : 0;
    compacting += x < cap.kappa && d.evp < evp ? 1 : 0;
  }
};

}  // namespace barreno::test
