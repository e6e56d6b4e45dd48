// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/arenisca_points.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

/// The fast return of Arenisca against the bisection of the paper, on the same substeps.
namespace barreno::test {

struct SolverDifference {
  double stress = 0.0;          ///< relative to the larger of strength and trial stress
  double plastic_strain = 0.0;  ///< of the volumetric one, relative to the largest strain around
  bool flows = false, sound = true;
};

/// Both solvers for one parameter set, with the substeps that the fast one chooses.
class TwoSolvers {
public:
  explicit TwoSolvers(Arenisca::Parameters p)
      : fast_(with_solver(p, 0)), slow_(with_solver(p, 1)) {}
  const Arenisca& model() const { return fast_; }

  SolverDifference compare(const RockPoint& point) {
    *record_ = {};
    Sym3 a = point.stress, b = point.stress;
    Arenisca::History ha = point.history, hb = point.history;
    const Outcome one = fast_.update_counted(point.increment, a, ha, *record_);
    arenisca::SubstepReplay replay{*record_};
    const Outcome two = slow_.update_counted(point.increment, b, hb, replay);
    const double strain = norm(point.increment.strain);
    const double trial =
        norm(point.stress) + 3.0 * fast_.rock().elasticity.upper_bound().bulk * strain;
    SolverDifference d;
    d.sound = one.status == two.status && !one.failed();
    d.flows = one.plastic_work > 0.0;
    d.stress = norm(a - b) / std::max(trial, strength());
    d.plastic_strain = std::fabs(ha.plastic_volume_strain - hb.plastic_volume_strain);
    return d;
  }

private:
  static Arenisca with_solver(Arenisca::Parameters p, int solver) {
    p.return_solver = solver;
    return Arenisca(p, 1.0);
  }
  double strength() const { return fast_.rock().stress_floor; }

  Arenisca fast_, slow_;
  std::unique_ptr<arenisca::SubstepRecord> record_ = std::make_unique<arenisca::SubstepRecord>();
};

}  // namespace barreno::test
