// SPDX-License-Identifier: BSD-3-Clause
#include "state/balance.hpp"
#include "state/ledger_table.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace barreno {
namespace {

/// Numbers that close: every term is there and no two are alike.
Ledger closed_ledger() {
  Ledger l;
  l.initial_mass = 4.0;
  l.launched_mass = 2.0;
  l.removed[0].mass = 0.25;
  l.removed[1].mass = 0.5;
  l.mass = 5.25;
  l.initial_momentum = 1.0;
  l.launched_momentum = -8.0;
  l.condition_impulse = 3.0;
  l.load_impulse = -0.5;
  l.body_impulse = 0.75;
  l.damping_impulse = -0.25;
  l.removed[2].momentum = -1.5;
  l.momentum = -2.5;
  l.initial_kinetic = 16.0;
  l.launched_kinetic = 32.0;
  l.prestress = 8.0;
  l.boundary_work = -4.0;
  l.body_work = 3.0;
  l.damped = 3.0;
  l.transfer = -2.0;
  l.stress_integration = 1.0;
  l.removed[0].kinetic = 5.0;
  l.elastic = 9.0;
  l.plastic = 11.0;
  l.viscous = 6.0;
  l.kinetic = 20.0;
  return l;
}

TEST(Balance, ClosesOnALedgerThatCloses) {
  const Ledger l = closed_ledger();
  EXPECT_EQ(mass_balance(l).error(), 0.0);
  EXPECT_EQ(momentum_balance(l).error(), 0.0);
  EXPECT_EQ(energy_balance(l).error(), 0.0);
}

TEST(Balance, IsRelativeToWhatCameIn) {
  Ledger l = closed_ledger();
  l.mass += 0.6;
  l.momentum += 1.0;
  l.kinetic += 0.6;
  EXPECT_NEAR(mass_balance(l).error(), 0.1, 1e-15);
  EXPECT_NEAR(energy_balance(l).error(), 0.6 / 63.0, 1e-15);
  EXPECT_NEAR(
      momentum_balance(l).error(),
      1.0 / (std::sqrt(2.0 * 4.0 * 16.0) + std::sqrt(2.0 * 2.0 * 32.0) +
             std::sqrt(2.0 * 4.0 * 7.0) + 4.5),
      1e-15
  );
}

TEST(Balance, OfNothingIsZeroAndSomethingFromNothingIsInfinite) {
  Ledger l;
  EXPECT_EQ(energy_balance(l).error(), 0.0);
  l.kinetic = 1.0;
  EXPECT_TRUE(std::isinf(energy_balance(l).error()));
}

/// A rigid body that strains its neighbours before it does any work.
TEST(Balance, IsRelativeToWhatNumericalErrorsMovedWhereNothingWasPutIn) {
  Ledger l;
  l.initial_mass = 2.0;
  l.elastic = 4.0;
  l.stress_integration = 4.0 - 1e-12;
  l.momentum = 1e-12;
  EXPECT_NEAR(energy_balance(l).error(), 0.25e-12, 1e-15);
  EXPECT_NEAR(momentum_balance(l).error(), 0.25e-12, 1e-15);
  l.boundary_work = 8.0;
  l.kinetic = 8.0;
  EXPECT_NEAR(energy_balance(l).error(), 0.125e-12, 1e-15);
  EXPECT_EQ(energy_balance(l).put_in, 8.0);
}

/// Forces of an explosive that begins to burn cancel but for round-off.
TEST(Balance, OfMomentumIsZeroWhereTheSumOfKineticEnergyDoesNotResolveIt) {
  Ledger l;
  l.initial_mass = 2.0;
  l.momentum = 1e-19;
  EXPECT_EQ(momentum_balance(l).error(), 0.0);
  l.kinetic = 1e-18;
  EXPECT_TRUE(std::isinf(momentum_balance(l).error()));
}

TEST(Balance, AddsTheRanksButNotTheSharedStepCount) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  OwnLedger mine;
  mine.kinetic += 20.0;
  mine.removed[1].count += 1.0 + comm->getRank();
  mine.retried_steps = 7.0;
  const Ledger sum = sum_over_ranks(*comm, mine);
  const double ranks = comm->getSize();
  EXPECT_EQ(sum.kinetic, 20.0 * ranks);
  EXPECT_EQ(total_removed(sum).count, 0.5 * ranks * (ranks + 1.0));
  EXPECT_EQ(sum.retried_steps, 7.0);
}

TEST(JetTableTotals, AreThoseOfCylindersOrOfTheSlabInsideTheGrid) {
  Scene scene;
  scene.grid.lower = {0.0, -1.0, 0.0};
  scene.grid.upper = {1.0, 1.0, 0.0};
  scene.jet.direction = -1.0;
  scene.jet.slugs = {{0.0, 10.0, 0.5, 0.25, 8.0}, {1.0, 5.0, 0.5, 0.25, 8.0}};
  const double pi = std::acos(-1.0);
  const JetTotals one = jet_table_totals(scene, 1);
  EXPECT_NEAR(one.mass, 8.0 * pi * 0.25 * 0.25, 1e-15);
  EXPECT_NEAR(one.momentum, -10.0 * one.mass, 1e-14);
  EXPECT_NEAR(one.kinetic, 50.0 * one.mass, 1e-13);
  EXPECT_NEAR(jet_table_totals(scene, 99).mass, 2.0 * one.mass, 1e-15);
  scene.grid.mode = Mode::plane_strain;
  EXPECT_NEAR(jet_table_totals(scene, 1).mass, 8.0 * 0.5 * 0.25, 1e-15);
}

/// A ledger in which one number of the struct is 1 and all others are 0.
Ledger only_term(std::size_t term) {
  Ledger ledger;
  auto& terms = static_cast<LedgerTerms<double>&>(ledger);
  reinterpret_cast<double*>(&terms)[term] = 1.0;
  return ledger;
}

TEST(LedgerTable, HasARowForEveryTerm) {
  constexpr std::size_t terms = sizeof(LedgerTerms<double>) / sizeof(double);
  for (std::size_t term = 0; term < terms; ++term) {
    const Ledger ledger = only_term(term);
    int found = 0;
    for (const LedgerRow& row : ledger_table()) found += row.value(ledger) == 1.0 ? 1 : 0;
    EXPECT_GT(found, 0) << "the " << term << "th number of LedgerTerms is in no row";
  }
  Ledger retried;
  retried.retried_steps = 1.0;
  EXPECT_EQ(ledger_row("retried").value(retried), 1.0);
}

TEST(LedgerTable, CountsItsColumnsOn) {
  const std::vector<const LedgerRow*> columns = ledger_columns();
  ASSERT_FALSE(columns.empty());
  std::set<std::string> names, paths;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    EXPECT_EQ(columns[i]->column, static_cast<int>(i) + 1) << columns[i]->name;
    EXPECT_TRUE(names.insert(columns[i]->name).second) << columns[i]->name;
  }
  for (const LedgerRow& row : ledger_table()) {
    EXPECT_FALSE(row.meaning.empty()) << row.name;
    if (!row.summary.empty()) {
      EXPECT_TRUE(paths.insert(row.summary).second) << row.summary;
    }
  }
}

/// The identities as docs/method.md has them, term by term.
TEST(LedgerTable, GivesEveryTermItsSign) {
  using L = Ledger;
  const auto remainder = [](double LedgerTerms<double>::*term, Balance (*balance)(const Ledger&)) {
    Ledger ledger;
    ledger.initial_kinetic = ledger.initial_mass = 1.0;  // so that no momentum is round-off
    const double before = balance(ledger).remainder;
    ledger.*term += 1.0;
    return balance(ledger).remainder - before;
  };
  EXPECT_EQ(remainder(&L::mass, mass_balance), 1.0);
  for (const auto term : {&L::initial_mass, &L::launched_mass})
    EXPECT_EQ(remainder(term, mass_balance), -1.0);
  EXPECT_EQ(remainder(&L::momentum, momentum_balance), 1.0);
  for (const auto term :
       {&L::initial_momentum,
        &L::launched_momentum,
        &L::condition_impulse,
        &L::load_impulse,
        &L::body_impulse,
        &L::damping_impulse,
        &L::rigid_impulse})
    EXPECT_EQ(remainder(term, momentum_balance), -1.0);
  for (const auto term :
       {&L::kinetic, &L::elastic, &L::plastic, &L::viscous, &L::friction, &L::damped})
    EXPECT_EQ(remainder(term, energy_balance), 1.0);
  for (const auto term :
       {&L::initial_kinetic,
        &L::launched_kinetic,
        &L::prestress,
        &L::explosive,
        &L::boundary_work,
        &L::body_work,
        &L::fluid_work,
        &L::transfer,
        &L::stress_integration})
    EXPECT_EQ(remainder(term, energy_balance), -1.0);
  for (const auto term : {&L::remembered, &L::held, &L::unloaded, &L::clipped})
    EXPECT_EQ(remainder(term, energy_balance), 0.0);
}

}  // namespace
}  // namespace barreno
