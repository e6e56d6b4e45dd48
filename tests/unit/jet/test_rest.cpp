// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "jet/estimate.hpp"
#include "jet/rest.hpp"
#include "scene/jet.hpp"
#include "state/balance.hpp"
#include "unit/output/synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace barreno {
namespace {

constexpr double us = 1e-6;
constexpr double contact = 9.5 * us, stop = 50.0 * us;
constexpr double stand_off = 0.01;

/// Of a jet whose last slug digs until the hole stops, with others to come.
RestRule rule_with(const std::vector<ComingSlug>& slugs = {}) {
  return {0.01, 2.0 * us, stand_off, slugs};
}
const double bottom = 1e-4 + 5000.0 * (stop - contact);

/// A slug of this share of the jet's mass that would reach the bottom at a time at 0.8 of its
/// velocity.
ComingSlug slug_arriving(double time, double share) {
  const double launch = 30.0 * us;
  return {launch, (stand_off + bottom) / (0.8 * (time - launch)), share * 0.01};
}

/// A hole that grows by 5 mm/us from the contact on, and stops.
Penetration hole_at(double time) {
  Penetration found;
  found.met = time >= contact;
  if (found.met) found.depth = 1e-4 + 5000.0 * (std::min(time, stop) - contact);
  return found;
}

/// Time of the first look, one each microsecond, at which a hole is at rest; 0: never.
template <class Hole>
double first_rest(RestWatch& watch, const Hole& hole, double first = 0.0) {
  for (int i = 0; i <= 200; ++i) {
    const double time = (i + 0.25) * us;
    if (time < first) continue;
    watch.look(time, hole(time));
    if (watch.last().at_rest) return time;
  }
  return 0.0;
}

TEST(Rest, AHoleThatHasStoppedIsAtRestAFifthOfItsTimeLater) {
  RestWatch watch(rule_with());
  // Met at the look at 10.25 us, stopped before that at 50.25 us: t - 0.2 (t - 10.25) >= 50.25.
  EXPECT_DOUBLE_EQ(first_rest(watch, hole_at), 60.25 * us);
  EXPECT_NEAR(watch.last().window, 10.0 * us, 1e-12);
  EXPECT_EQ(watch.last().growth, 0.0);
  EXPECT_EQ(
      rest_sentence(watch.last()),
      "The hole is at rest at 60.25 us: its depth grew by 0 % in the last 10 us, and nothing of "
      "the "
      "jet that can still reach the bottom is on its way."
  );
}

TEST(Rest, ALateSlugHoldsTheEndOpen) {
  RestWatch watch(rule_with({slug_arriving(120.0 * us, 0.01)}));
  EXPECT_DOUBLE_EQ(first_rest(watch, hole_at), 120.25 * us);
  RestWatch open(rule_with({slug_arriving(120.0 * us, 0.01)}));
  open.look(contact, hole_at(contact));
  open.look(stop, hole_at(stop));
  open.look(100.0 * us, hole_at(100.0 * us));
  EXPECT_EQ(
      rest_sentence(open.last()),
      "The hole is not at rest: its depth grew at 0 m/s in the last 18.1 us, and 1 % of the "
      "jet's mass, which still digs, is on its way."
  );
  RestWatch crumbs(rule_with({slug_arriving(120.0 * us, 0.9e-3)}));
  EXPECT_DOUBLE_EQ(first_rest(crumbs, hole_at), 60.25 * us) << "less than counts of the depth";
}

TEST(Rest, AHoleThatGrowsIsNotAtRestHoweverSlowly) {
  RestWatch watch(rule_with());
  const auto creeping = [](double t) {
    Penetration found = hole_at(t);
    if (found.met) found.depth = 0.1 + 0.2 * t / (500.0 * us);
    return found;
  };
  EXPECT_EQ(first_rest(watch, creeping), 0.0);
  EXPECT_NEAR(watch.last().rate(), 400.0, 12.0);  // or with the row before the window
  EXPECT_EQ(
      rest_sentence(watch.last()).find("The hole is not at rest: its depth grew at 400 m/s"), 0U
  ) << rest_sentence(watch.last());
  // 0.09 % in a window of 38 us is growth within the rule.
  RestWatch slower(rule_with());
  const auto settling = [](double t) {
    Penetration found = hole_at(t);
    if (found.met && t > stop) found.depth *= 1.0 + 0.02e-3 * (t - stop) / us;
    return found;
  };
  EXPECT_GT(first_rest(slower, settling), 60.0 * us);
}

TEST(Rest, MetalThrownBackFillsNoHole) {
  RestWatch watch(rule_with());
  const auto back = [](double t) {
    Penetration found = hole_at(t);
    if (t > stop) found.depth *= 0.9 + 0.0005 * t / us;
    return found;
  };
  EXPECT_DOUBLE_EQ(first_rest(watch, back), 59.25 * us);  // the deepest was seen at 49.25 us
}

TEST(Rest, BeginsWithTheTargetAndWaitsForTheLeastWindow) {
  RestWatch watch(rule_with());
  EXPECT_EQ(first_rest(watch, [](double) { return Penetration{}; }), 0.0);
  EXPECT_EQ(
      rest_sentence(watch.last()), "There is no hole: the jet has not met its target by 200.2 us."
  );
  RestWatch slow({0.01, 30.0 * us});
  EXPECT_DOUBLE_EQ(first_rest(slow, hole_at), 80.25 * us);
}

TEST(Rest, AJetThatIsThroughEndsWhenAllOfItIs) {
  RestWatch watch(rule_with({slug_arriving(90.0 * us, 0.5)}));
  const auto through = [](double t) {
    Penetration found = hole_at(t);
    found.through = t >= stop;
    return found;
  };
  EXPECT_DOUBLE_EQ(first_rest(watch, through), 90.25 * us);
  EXPECT_EQ(
      rest_sentence(watch.last()),
      "There is no depth: the jet has come out of the rear of the target, and nothing of it that "
      "still digs is on its way at 90.25 us."
  );
}

/// A hole that is as wide as the jet to its bottom and grows until it stops; a thread of spent
/// metal goes on from there at 0.5 mm/us.
Penetration threaded_hole_at(double time) {
  Penetration found = hole_at(time);
  found.probed_depth = found.depth;
  found.probed_volume = 1e-4 * found.depth;
  if (time > stop) found.depth += 500.0 * (time - stop);
  return found;
}

TEST(Rest, AThreadBehindAHoleAsWideAsTheJetDoesNotCount) {
  RestWatch watch(rule_with());
  EXPECT_DOUBLE_EQ(first_rest(watch, threaded_hole_at), 60.25 * us);
  EXPECT_TRUE(watch.last().probed);
  EXPECT_NEAR(watch.last().rate(), 500.0, 1e-6);
  EXPECT_EQ(watch.last().probed_growth, 0.0);
  EXPECT_TRUE(has_growing_thread(watch.last()));
  EXPECT_EQ(
      rest_sentence(watch.last()),
      "The hole is at rest at 60.25 us: as far as it is as wide as the jet, its depth grew by 0 % "
      "in "
      "the last 10 us, its volume by 0 %, and nothing of the jet that can still reach the bottom "
      "is "
      "on its way. Its narrower end grew at 500 m/s; such a thread may still grow."
  );
  RestWatch whole(rule_with());
  const auto plain = [](double t) {
    Penetration found = threaded_hole_at(t);
    found.depth = found.probed_depth;
    return found;
  };
  EXPECT_DOUBLE_EQ(first_rest(whole, plain), 60.25 * us);
  EXPECT_FALSE(has_growing_thread(whole.last()));
  EXPECT_EQ(
      rest_sentence(whole.last()),
      "The hole is at rest at 60.25 us: its depth grew by 0 % in the last 10 us, its volume by 0 "
      "%, "
      "and nothing of the jet that can still reach the bottom is on its way."
  );
}

TEST(Rest, AThreadCountsWhereMostOfTheHoleIsNarrow) {
  const auto with_share = [](double share) {
    return [share](double t) {
      Penetration found = threaded_hole_at(t);
      found.probed_depth *= share;
      return found;
    };
  };
  // 0.51 of the hole that stops is half of a depth that is 2 % larger: at 58.4 us, before the end.
  RestWatch narrow(rule_with());
  EXPECT_EQ(first_rest(narrow, with_share(0.51)), 0.0);
  EXPECT_FALSE(narrow.last().probed);
  EXPECT_EQ(
      rest_sentence(narrow.last()).find("The hole is not at rest: its depth grew at 500 m/s"), 0U
  );
  RestWatch wide(rule_with());
  EXPECT_DOUBLE_EQ(first_rest(wide, with_share(0.53)), 60.25 * us);
}

TEST(Rest, AHoleThatWidensIsNotAtRest) {
  const auto widening = [](double t) {
    Penetration found = threaded_hole_at(t);
    if (t > stop) found.probed_volume *= 1.0 + 0.2e-3 * (std::min(t, 90.0 * us) - stop) / us;
    return found;
  };
  RestWatch watch(rule_with());
  // The volume grows by 0.02 % in a microsecond: t - w >= 85.11 us, a look later.
  const double rest = first_rest(watch, widening);
  EXPECT_GT(rest, 103.0 * us);
  EXPECT_LT(rest, 106.0 * us);
  EXPECT_LE(watch.last().volume_growth, rest_share * watch.last().probed_volume);
  RestWatch open(rule_with());
  for (int i = 0; i <= 80; ++i) open.look((i + 0.25) * us, widening((i + 0.25) * us));
  EXPECT_EQ(
      rest_sentence(open.last()),
      "The hole is not at rest: its depth grew at 500 m/s in the last 14 us, as far as it is as "
      "wide as the jet by 0 %, its volume there by 0.28 %."
  );
}

/// A hole of 202.6 mm and 20.26 cm3 whose wall has 7181 mm2, that goes on as it is told.
template <class Growth>
double first_rest_of_cells(double cell, const Growth& goes_on, bool plane = false) {
  RestRule rule = rule_with();
  rule.row = cell;
  rule.plane = plane;
  RestWatch watch(rule);
  return first_rest(watch, [&](double t) {
    Penetration found = threaded_hole_at(t);
    if (t > stop) goes_on(found, (t - stop) / us);
    return found;
  });
}

TEST(Rest, ARowOfCellsIsNoGrowth) {
  const double row = 1e-3;  // 0.5 % of the depth
  const auto rows = [row](double each) {
    return [row, each](Penetration& found, double since) {
      found.probed_depth += row * std::floor(since / each);
    };
  };
  // One row in each 30 us, longer than the window of up to 38 us allows two of.
  EXPECT_DOUBLE_EQ(first_rest_of_cells(row, rows(30.0)), 60.25 * us);
  EXPECT_EQ(first_rest_of_cells(row, rows(4.0)), 0.0) << "rows follow each other";
  EXPECT_EQ(first_rest_of_cells(0.4 * row, rows(7.0)), 0.0) << "rows of smaller cells";
}

TEST(Rest, AWallThatMovesByLessThanATenthOfACellIsNoGrowth) {
  const double wall = 2.0 * std::sqrt(pi * 1e-4 * bottom * bottom);
  const auto widening = [wall](double each) {  // [length/us] of the wall
    return [wall, each](Penetration& found, double since) {
      found.probed_volume += wall * each * since;
    };
  };
  const double cell = 1e-3;
  // In the last 10 to 38 us: 0.02 to 0.076 of a cell, and 0.11 of it from the first window on.
  EXPECT_DOUBLE_EQ(first_rest_of_cells(cell, widening(0.002 * cell)), 60.25 * us);
  EXPECT_EQ(first_rest_of_cells(cell, widening(0.012 * cell)), 0.0);
  EXPECT_EQ(first_rest_of_cells(0.1 * cell, widening(0.002 * cell)), 0.0) << "smaller cells";
  // Plane strain: walls on both sides, of the depth only.
  const auto parting = [](double each) {
    return [each](Penetration& found, double since) {
      found.probed_volume += 2.0 * bottom * each * since;
    };
  };
  EXPECT_DOUBLE_EQ(first_rest_of_cells(cell, parting(0.002 * cell), true), 60.25 * us);
  EXPECT_EQ(first_rest_of_cells(cell, parting(0.012 * cell), true), 0.0);
}

TEST(Rest, NecksThatComeAndGoAreNoGrowth) {
  RestWatch watch(rule_with());
  const auto necked = [](double t) {
    Penetration found = threaded_hole_at(t);
    if (t > stop && static_cast<int>(t / us) % 5 != 0) {
      found.probed_depth *= 0.9;
      found.probed_volume *= 0.98;
    }
    return found;
  };
  EXPECT_DOUBLE_EQ(first_rest(watch, necked), 60.25 * us);
}

/// A train of late slugs digs in bursts of 0.5 %.
TEST(Rest, AHoleThatGrowsInBurstsIsAtRestAfterTheLast) {
  const auto bursts = [](double every) {
    return [every](double t) {
      Penetration found = threaded_hole_at(t);
      if (t > stop) {
        const double grown = 1.0 + 5e-3 * std::floor((std::min(t, 120.0 * us) - stop) / every);
        found.probed_depth *= grown;
        found.probed_volume *= grown;
      }
      return found;
    };
  };
  RestWatch watch(rule_with());
  EXPECT_GT(first_rest(watch, bursts(9.0 * us)), 113.0 * us + 20.0 * us)
      << "shorter than the window";
  // Longer pauses are bridged by the slugs that make the next burst.
  RestWatch rare(rule_with({slug_arriving(95.0 * us, 0.01)}));
  EXPECT_GT(first_rest(rare, bursts(40.0 * us)), 95.0 * us);
}

TEST(Rest, SlugsAreOnTheirWayToTheHoleAsWideAsTheJet) {
  const RestRule rule = rule_with({slug_arriving(70.0 * us, 0.01)});
  RestWatch watch(rule);
  EXPECT_DOUBLE_EQ(first_rest(watch, threaded_hole_at), 70.25 * us);
  EXPECT_GT(share_on_its_way(rule, watch.last().time, watch.last().depth), rest_share)
      << "to the end of the thread";
}

TEST(Rest, AResumedWatchDecidesAsTheStraightOne) {
  const RestRule rule = rule_with({slug_arriving(63.0 * us, 0.002)});
  for (int cut = 1; cut < 60; cut += 7) {
    RestWatch first(rule);
    for (int i = 0; i < cut; ++i) first.look((i + 0.25) * us, hole_at((i + 0.25) * us));
    EXPECT_EQ(fault_of_rest(first.numbers(), cut * us), "");
    EXPECT_EQ(is_at_rest(first.numbers()), first.last().at_rest);
    RestWatch resumed(rule, first.numbers());
    EXPECT_EQ(resumed.numbers(), first.numbers());
    EXPECT_DOUBLE_EQ(first_rest(resumed, hole_at, cut * us), 63.25 * us) << cut;
  }
}

TEST(Rest, AResumedWatchKnowsTheHoleAsWideAsTheJet) {
  for (int cut = 1; cut < 60; cut += 7) {
    RestWatch first(rule_with());
    for (int i = 0; i < cut; ++i) first.look((i + 0.25) * us, threaded_hole_at((i + 0.25) * us));
    EXPECT_EQ(fault_of_rest(first.numbers(), cut * us), "");
    RestWatch resumed(rule_with(), first.numbers());
    EXPECT_EQ(resumed.numbers(), first.numbers());
    EXPECT_EQ(rest_sentence(resumed.last()), rest_sentence(first.last()));
    EXPECT_DOUBLE_EQ(first_rest(resumed, threaded_hole_at, cut * us), 60.25 * us) << cut;
  }
}

TEST(Rest, NumbersOfACheckpointThatNoHoleHasAreNamed) {
  RestWatch watch(rule_with());
  for (int i = 0; i < 30; ++i) watch.look(i * us, hole_at(i * us));
  const RunNumbers good = watch.numbers();
  EXPECT_EQ(fault_of_rest(good, 30.0 * us), "");
  EXPECT_EQ(fault_of_rest({}, 30.0 * us), "") << "of a run that does not watch";
  EXPECT_NE(fault_of_rest(good, 20.0 * us), "") << "a look that is still to come";
  RunNumbers bad = good;
  bad["rest_look"].pop_back();
  EXPECT_NE(fault_of_rest(bad, 30.0 * us), "");
  bad = good;
  ASSERT_EQ(bad["rest_samples"].size() % 4, 0U);
  std::swap(bad["rest_samples"][1], bad["rest_samples"][5]);
  EXPECT_NE(fault_of_rest(bad, 30.0 * us), "") << "a hole that shrinks";
  bad = good;
  bad["rest_samples"].pop_back();
  EXPECT_NE(fault_of_rest(bad, 30.0 * us), "");
  bad = good;
  bad["rest_samples"].clear();
  EXPECT_NE(fault_of_rest(bad, 30.0 * us), "");
}

TEST(RestRule, WaitsForTheSlugsThatDig) {
  Scene scene = synthetic::make_scene();  // six slugs, each slower by 200 m/s than the one before
  scene.cut_off_velocity = synthetic::tip_speed - 500.0;
  const RestRule rule = rest_rule(scene);
  ASSERT_EQ(rule.slugs.size(), 3U);
  EXPECT_DOUBLE_EQ(rule.jet_mass, jet_table_totals(scene, 6).mass);
  EXPECT_DOUBLE_EQ(rule.stand_off, -synthetic::launch_plane);
  EXPECT_DOUBLE_EQ(share_on_its_way(rule, 0.0, 0.02), 0.5);
  const ComingSlug& last = rule.slugs.back();
  const double arrival = last.time + (rule.stand_off + 0.02) / (0.8 * last.velocity);
  EXPECT_NEAR(share_on_its_way(rule, 0.999 * arrival, 0.02), 1.0 / 6.0, 1e-12);
  EXPECT_EQ(share_on_its_way(rule, 1.001 * arrival, 0.02), 0.0);
  EXPECT_GT(share_on_its_way(rule, 1.001 * arrival, 0.03), 0.0) << "a deeper bottom is farther";
}

TEST(PredictedRest, ComesAfterTheLastSlugThatDigs) {
  Scene scene = synthetic::make_scene();
  scene.cut_off_velocity = 1.0;
  const JetEstimate whole = estimate_jet(scene, 1.0);
  const double first = first_arrival(scene, jet_path(scene));
  ASSERT_FALSE(whole.passed);
  const RestRule rule = rest_rule(scene);
  double expected = std::max(
      whole.time + rule.least_window, (whole.time - rest_window * first) / (1.0 - rest_window)
  );
  for (const ComingSlug& slug : rule.slugs)
    expected =
        std::max(expected, slug.time + (rule.stand_off + whole.depth) / (0.8 * slug.velocity));
  EXPECT_DOUBLE_EQ(predicted_rest(scene), expected);
  const double all = predicted_rest(scene);
  scene.cut_off_velocity = synthetic::tip_speed - 500.0;
  EXPECT_LT(predicted_rest(scene), all) << "nobody waits for slugs that do not dig";
  scene.at_rest = true;
  scene.end_time = 1.0;
  EXPECT_EQ(expected_end(scene), predicted_rest(scene));
  scene.end_time = 1e-7;
  EXPECT_EQ(expected_end(scene), 1e-7) << "not beyond the longest time";
  scene.at_rest = false;
  scene.end_time = 1.0;
  EXPECT_EQ(expected_end(scene), 1.0);
}

TEST(CutOffVelocity, IsATenthOfTheTipsUnlessTheDeckHasOne) {
  Scene scene = synthetic::make_scene();
  EXPECT_DOUBLE_EQ(cut_off_velocity(scene), 0.2 * synthetic::tip_speed);
  scene.cut_off_velocity = 1300.0;
  EXPECT_EQ(cut_off_velocity(scene), 1300.0);
}

}  // namespace
}  // namespace barreno
