// SPDX-License-Identifier: BSD-3-Clause
// Which term of the ledger takes what the step has found.
#include "step/tally_step.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

TEST(TallyStep, SumsOfTheParticlesReplaceThoseOfTheLastStep) {
  OwnLedger ledger;
  ledger.mass += 7.0;
  std::vector<Reaction> reactions;
  StepTally tally;
  tally.moved.mass += 2.0;
  tally.moved.momentum += -3.0;
  tally.moved.kinetic += 5.0;
  tally_step(tally, ledger, reactions);
  EXPECT_EQ(ledger.mass, 2.0);
  EXPECT_EQ(ledger.momentum, -3.0);
  EXPECT_EQ(ledger.kinetic, 5.0);
}

/// Whatever the nodes and particles report, the identity of the ledger holds: each term of a step
/// stands on both sides once.
TEST(TallyStep, EveryTermEntersTheEnergyBalanceOnBothSides) {
  OwnLedger ledger;
  std::vector<Reaction> reactions;
  StepTally tally;
  tally.grid.condition_work += 1.0;
  tally.grid.absorbed += 2.0;
  tally.grid.damped += 4.0;
  tally.grid.force_work += 8.0;
  tally.grid.kinetic_before += 16.0;
  tally.grid.kinetic_after += 32.0;
  tally.applied_work += 64.0;
  tally.stress.elastic += 128.0;
  tally.stress.plastic += 256.0;
  tally.stress.viscous += 512.0;
  tally.stress.stress_work += 1024.0;
  tally.moved.gain += 2048.0;
  tally.moved.kinetic += 4096.0;
  tally.filter.kinetic += 8192.0;
  for (int step = 0; step < 2; ++step) tally_step(tally, ledger, reactions);
  EXPECT_EQ(ledger.kinetic, 4096.0);
  EXPECT_EQ(ledger.elastic, 2.0 * 128.0);
  EXPECT_EQ(ledger.plastic, 2.0 * 256.0);
  EXPECT_EQ(ledger.viscous, 2.0 * 512.0);
  EXPECT_EQ(ledger.damped, 2.0 * 4.0);
  EXPECT_EQ(ledger.boundary_work, 2.0 * (1.0 + 2.0));
  EXPECT_EQ(ledger.transfer, 2.0 * (16.0 - 32.0 + 2048.0 + 8192.0));
  EXPECT_EQ(ledger.stress_integration, 2.0 * (8.0 + 4.0 - 2.0 - 64.0 + 1024.0));
}

TEST(TallyStep, RigidBodiesTakeTheOppositeOfTheirReaction) {
  OwnLedger ledger;
  std::vector<Reaction> reactions(1);
  StepTally tally;
  tally.rigid.work += 3.0;
  tally.rigid.tangential_work += 10.0;
  tally.grid.tangential_work += 4.0;
  tally.grid.contact_work += 0.5;
  tally.rigid.reaction[0][0] += 1.5;
  tally.rigid.reaction[0][1] += -2.5;
  tally_step(tally, ledger, reactions);
  EXPECT_EQ(ledger.boundary_work, 3.0);
  EXPECT_EQ(ledger.rigid_impulse, 2.5);
  EXPECT_EQ(ledger.friction, 10.0 - 4.0);
  EXPECT_EQ(ledger.transfer, 6.0 + 0.5 - 3.0);
  EXPECT_EQ(reactions[0].impulse[0], 1.5);
  EXPECT_EQ(reactions[0].impulse[1], -2.5);
}

TEST(TallyParticleSteps, SkippedParticlesAreCountedApartAndRigidOnesNot) {
  std::vector<Particles> sets(2);
  sets[0].count = 100;
  sets[1].count = 30;
  sets[1].rigid = true;
  Dormancy dormancy;
  dormancy.skipped_rows = 64;
  double advanced = 1.0, skipped = 2.0;
  tally_particle_steps(sets, dormancy, {}, advanced, skipped);
  EXPECT_EQ(advanced, 37.0);
  EXPECT_EQ(skipped, 66.0);
}

TEST(TallyParticleSteps, AParticleWithinItsOwnStepIsNotSkippedByAllOfIt) {
  std::vector<Particles> sets(1);
  sets[0].count = 100;
  Dormancy dormancy;
  dormancy.skipped_rows = 64;
  Subcycling subcycling;
  subcycling.parts = 2;
  double advanced = 0.0, skipped = 0.0;
  tally_particle_steps(sets, dormancy, subcycling, advanced, skipped);
  EXPECT_EQ(skipped, 0.0);
  subcycling.part = 1;  // the last: what is skipped is dormant
  tally_particle_steps(sets, dormancy, subcycling, advanced, skipped);
  EXPECT_EQ(advanced, 72.0);
  EXPECT_EQ(skipped, 64.0);
}

}  // namespace
}  // namespace barreno
