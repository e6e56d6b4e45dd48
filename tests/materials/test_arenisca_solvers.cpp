// SPDX-License-Identifier: BSD-3-Clause
// Arenisca's fast return against the bisection of the paper, on the same substeps.
#include "materials/solver_agreement.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

namespace barreno::test {
namespace {

/// Updates of the whole test; the slow form asks for a million.
long update_count() {
  const char* asked = std::getenv("BARRENO_UPDATES");
  return asked != nullptr ? std::atol(asked) : 20000;
}

struct Agreement {
  long updates = 0, flows = 0, unsound = 0, apart = 0;
  double stress = 0.0, plastic_strain = 0.0;

  void add(const SolverDifference& d) {
    ++updates;
    flows += d.flows ? 1 : 0;
    unsound += d.sound ? 0 : 1;
    apart += d.stress > 1e-9 ? 1 : 0;
    stress = std::max(stress, d.stress);
    plastic_strain = std::max(plastic_strain, d.plastic_strain);
  }
};

/// Half as in a penetration run, half over every state, of one kind of rock.
Agreement compare(const Arenisca::Parameters& set, unsigned seed, long count, Places& places) {
  TwoSolvers solvers(set);
  RockSampler sampler(solvers.model(), seed);
  const bool porous = set.p3_crush_curve > 0.0;
  Agreement agreement;
  for (long i = 0; i < count; ++i) {
    const bool anywhere = !porous || i % 2 == 0;
    const RockPoint point = anywhere ? sampler.anywhere(-6.0, -3.0) : sampler.flowing();
    const SolverDifference d = solvers.compare(point);
    agreement.add(d);
    if (d.flows) places.add(solvers.model().rock(), point, d);
  }
  return agreement;
}

// To 1e-9 of the larger of strength and trial stress.
TEST(AreniscaSolvers, AgreeOnTheSameSubsteps) {
  const auto sets = sets_of_all_kinds();
  const long each = update_count() / static_cast<long>(sets.size());
  Places places;
  long updates = 0, flows = 0;
  double worst = 0.0;
  for (std::size_t k = 0; k < sets.size(); ++k) {
    SCOPED_TRACE(k);
    const Agreement agreement = compare(sets[k], static_cast<unsigned>(k), each, places);
    std::printf(
        "set %zu: %ld updates, %ld flow, worst stress %.1e, plastic strain %.1e, %ld above 1e-9\n",
        k,
        agreement.updates,
        agreement.flows,
        agreement.stress,
        agreement.plastic_strain,
        agreement.apart
    );
    EXPECT_EQ(agreement.unsound, 0);
    EXPECT_LE(agreement.stress, 1e-9);
    EXPECT_LE(agreement.plastic_strain, 1e-10);
    EXPECT_GT(agreement.flows, agreement.updates / 5);
    updates += agreement.updates;
    flows += agreement.flows;
    worst = std::max(worst, agreement.stress);
  }
  std::printf("%ld updates, %ld flow: worst difference of stress %.1e\n", updates, flows, worst);
  std::printf(
      "ended at: vertex %ld, tip of the cap %ld, branch point %ld, hydrostat %ld, closed pores "
      "%ld, "
      "dilating cap %ld, compacting cap %ld\n",
      places.vertex,
      places.tip,
      places.branch,
      places.hydrostat,
      places.closed,
      places.dilating,
      places.compacting
  );
  for (const long count :
       {places.vertex,
        places.tip,
        places.branch,
        places.hydrostat,
        places.closed,
        places.dilating,
        places.compacting})
    EXPECT_GT(count, update_count() / 2000);
}

// Pores all but closed, which open under shear: the cap retracts faster than the rock dilates, the
// condition of the return has three roots, and both solvers are to take the first. States at which
// the bisection once took the last.
TEST(AreniscaSolvers, TakeTheFirstOfSeveralRoots) {
  Arenisca::Parameters set = Sample<Arenisca>::parameters();
  set.PEAKI1 = set.STREN = set.YSLOPE = 0.0;
  const Arenisca model(set, 1.0);
  const arenisca::Rock& rock = model.rock();
  arenisca::NoCounter none;
  const struct {
    double x, q, evp, first_root;
  } cases[] = {
      {-3.8556393957e9, 1.6772148576e9, -0.21999509568256007, 2.379414687503e-7},
      {-3.5421607578e9, 1.5409322729e9, -0.2199887407072, 1.876688892288e-6},
      {-3.6074788514e9, 1.5692917330e9, -0.2199898605322, 8.081550609274e-7}};
  for (const auto& c : cases) {
    const arenisca::Moduli m = rock.elasticity.moduli_at(c.x, c.evp);
    const double metric = 9.0 * m.bulk / m.shear;
    const arenisca::Trial trial{c.x, c.q, metric, 3.0 * m.bulk, c.evp, rock.cap_at(c.evp)};
    const auto fast = arenisca::return_fast(rock.surface, rock.crush, trial, none);
    const auto slow = arenisca::return_bisection(rock.surface, rock.crush, trial, none);
    EXPECT_NEAR(fast.x, slow.x, 1e-9 * std::fabs(c.x));
    EXPECT_NEAR(fast.q, slow.q, 1e-9 * std::fabs(c.x));
    EXPECT_NEAR(fast.evp - c.evp, c.first_root, 1e-3 * c.first_root);
  }
}

}  // namespace
}  // namespace barreno::test
