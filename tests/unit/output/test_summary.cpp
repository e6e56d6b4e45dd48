// SPDX-License-Identifier: BSD-3-Clause
#include "base/build_facts.hpp"
#include "output/share_numbers.hpp"
#include "output/summary.hpp"
#include "scene/input_speeds.hpp"
#include "state/balance.hpp"
#include "synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace barreno {
namespace {

TEST(Summary, ComparesTheLaunchedJetWithItsTable) {
  const Scene scene = synthetic::make_scene();
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  State state = synthetic::make_state(scene, comm);
  synthetic::move_to(scene, state, 2.5e-6);
  RunTotals totals = sum_totals(state);
  totals.ledger.launched_mass = 1.5 * jet_table_totals(scene, 3).mass;
  const RunSummary summary = summarise(scene, state, 2.0, 1.5);
  EXPECT_GT(summary.bytes_per_particle, 100.0);
  EXPECT_GE(summary.peak_resident_bytes, summary.largest_rank_peak_bytes);
  const BuildFacts build = {{"commit", "b6d2"}, {"MPI", "Open MPI v4"}};
  const std::string text = summary_text(
      scene,
      state,
      {"out", "deck.xml", "", "1.0", {}, {}, {}, build},
      totals,
      {},
      summary,
      {false, "a \"reason\"", 3}
  );
  for (const char* word :
       {"\"commit\": \"b6d2\"",
        "\"MPI\": \"Open MPI v4\"",
        "\"slugs_launched\": 3",
        "\"difference\": 0.5",
        "\"reason\": \"a \\\"reason\\\"\"",
        "\"exit_code\": 3",
        "\"finished\": false",
        "\"mode\": \"axisymmetric\"",
        "\"wall_seconds\": 2"})
    EXPECT_NE(text.find(word), std::string::npos) << word << "\n" << text;
}

/// A needle and a fast particle, of two; all bounds are in the file.
TEST(Summary, CountsKinematicAnomalies) {
  const Scene scene = synthetic::make_scene();
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  State state = synthetic::make_state(scene, comm);
  synthetic::move_to(scene, state, 2.5e-6);
  const double input = largest_input_speed(scene);
  EXPECT_EQ(input, scene.jet.slugs.front().velocity);
  const auto of = static_cast<std::size_t>(scene.bodies.front().material);
  const std::vector<Anomalies> before = count_anomalies(scene, state);
  Particles& particles = state.particles[of];
  ASSERT_GE(particles.count, 2);
  particles.deformation_gradient(0, 3) = 1.5 * anomalous_stretch;
  particles.velocity(1, 1) = 1.01 * anomalous_speed * input;
  const std::vector<Anomalies> after = count_anomalies(scene, state);
  EXPECT_EQ(after[of].stretched, before[of].stretched + comm->getSize());
  EXPECT_EQ(after[of].ejected, before[of].ejected + comm->getSize());
  EXPECT_DOUBLE_EQ(after[of].largest_stretch, 1.5 * anomalous_stretch);
  EXPECT_DOUBLE_EQ(after[of].largest_speed, 1.01 * anomalous_speed * input);
  particles.body(0) |= debris_bit;
  EXPECT_EQ(count_anomalies(scene, state)[of].stretched, before[of].stretched);
  RunSummary summary;
  summary.anomalies = after;
  const std::string text = summary_text(
      scene, state, {"out", "deck.xml", "", "1.0", {}}, sum_totals(state), {}, summary, {}
  );
  const std::string stretched =
      "\"stretched\": " + std::to_string(static_cast<int>(after[of].stretched));
  for (const char* word : {"\"kinematic_anomalies\"", "\"stretch_bound\": 20", stretched.c_str()})
    EXPECT_NE(text.find(word), std::string::npos) << word;
}

/// Errors that cancel at the end, or have gone by then, are told all the same, with their first
/// row.
TEST(Summary, WarnsOfNumericalErrorsSinceTheirFirstRow) {
  const auto shares_of_rows = [](double stress, double transfer) {
    return largest_shares({{1e-6, 10.0, 0.5, -0.5}, {2e-6, 50.0, stress, transfer}, {3e-6, 100.0}});
  };
  EXPECT_FALSE(shares_of_rows(9.0, -9.0).too_large()) << "a tenth of the most that was put in";
  EXPECT_FALSE(largest_shares({}).too_large());
  EXPECT_EQ(largest_shares({{1e-6, 50.0}, {2e-6, 10.0, 2.0, 0.0}}).since, 2e-6)
      << "a fifth of what the balance counts at the end";
  const NumericalShares shares = shares_of_rows(30.0, -40.0);
  EXPECT_TRUE(shares.too_large());
  EXPECT_EQ(shares.since, 2e-6);
  EXPECT_DOUBLE_EQ(shares.stress_integration, 0.3);
  EXPECT_DOUBLE_EQ(shares.transfer, -0.4);

  Scene scene = synthetic::make_scene();
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  State state = synthetic::make_state(scene, comm);
  Particles& particles = state.particles[0];
  if (particles.count > 0) particles.deformation_gradient(0, 3) = 7.0;
  const Extremes extremes = find_extremes(scene, state);
  EXPECT_DOUBLE_EQ(extremes.most_stretched.value, 7.0);
  EXPECT_EQ(extremes.most_stretched.material, 0);
  EXPECT_EQ(extremes.hottest.id, -1) << "no material knows its temperature";
  EXPECT_EQ(numerical_energy_sentence(scene, {}, extremes), "");
  std::string text = numerical_energy_sentence(scene, shares, extremes);
  for (const char* word :
       {"since t = 2e-06 s",
        "cancel in the sum",
        "'steel'",
        "7 times",
        "modified stress last",
        "2 mm now",
        "Courant Fraction"})
    EXPECT_NE(text.find(word), std::string::npos) << word << "\n" << text;
  EXPECT_EQ(text.find("Volume Relaxation"), std::string::npos) << text;

  // What the run does already is no advice.
  scene.step.order = Order::modified_stress_last;
  scene.step.courant_fraction = 0.4;
  scene.materials[2].volume_relaxation = 20.0;
  text = numerical_energy_sentence(scene, shares, extremes);
  EXPECT_EQ(text.find("modified stress last"), std::string::npos) << text;
  EXPECT_EQ(text.find("Courant Fraction"), std::string::npos) << text;
  EXPECT_NE(text.find("\"Volume Relaxation\" of 'tungsten' to 0"), std::string::npos) << text;
}

TEST(Summary, SaysWhichCellsAndStepsTheWorkWentTo) {
  StepShares shares;
  EXPECT_TRUE(shares_by_cell_size(1e-3, shares).empty());
  EXPECT_TRUE(shares_by_step_length(shares).empty());
  shares.of_level[0] = 10.0;
  shares.of_level[2] = 30.0;
  shares.of_length[0] = 40.0;
  EXPECT_EQ(share_text(shares_by_cell_size(1e-3, shares)), "1 mm 25 %, 0.25 mm 75 %");
  EXPECT_TRUE(shares_by_step_length(shares).empty()) << "all steps are of one length";
  shares.of_length[3] = 120.0;
  EXPECT_EQ(share_text(shares_by_step_length(shares)), "1 part 25 %, 8 parts 75 %");

  const Scene scene = synthetic::make_scene();
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const State state = synthetic::make_state(scene, comm);
  RunTotals totals = sum_totals(state);
  totals.step_shares = shares_of(values_of(shares));
  const std::string text =
      summary_text(scene, state, {"out", "deck.xml", "", "1.0", {}}, totals, {}, {}, {});
  EXPECT_NE(text.find("\"8 parts\": 0.75"), std::string::npos) << text;
}

TEST(Summary, SaysWhichMaterialHasWhichEnergy) {
  const Scene scene = synthetic::make_scene();
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const State state = synthetic::make_state(scene, comm);
  RunTotals totals = sum_totals(state);
  totals.ledger.materials.assign(scene.materials.size(), {});
  totals.ledger.materials[1] = {1.0, -2.5, 3.0, 4.5, 0.5};
  const std::string text =
      summary_text(scene, state, {"out", "deck.xml", "", "1.0", {}}, totals, {}, {}, {});
  const std::string wanted =
      "\"" + scene.materials[1].name() +
      "\": {\n          \"prestress\": 1,\n          \"elastic\": -2.5,\n          "
      "\"plastic\": 3,\n          \"viscous\": 4.5,\n          \"explosive\": 0.5\n";
  EXPECT_NE(text.find(wanted), std::string::npos) << wanted << text;
}

TEST(Summary, SaysWhatSetTheSteps) {
  const Scene scene = synthetic::make_scene();
  StepLimits limits = make_step_limits(scene);
  EXPECT_TRUE(shares_of_limits(scene, limits).empty());
  const auto materials = static_cast<int>(scene.materials.size());
  count_step(1, 3e-6, 4e-8, limits);
  count_step(1, 3e-6, 2e-8, limits);
  count_step(row_of(OtherLimit::growth, materials), 2e-6, 1e-8, limits);
  limits = step_limits_of(values_of(limits));
  EXPECT_EQ(
      share_text(shares_of_limits(scene, limits)),
      scene.materials[1].name() + " 75 %, growth limit 25 %"
  );
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const State state = synthetic::make_state(scene, comm);
  RunTotals totals = sum_totals(state);
  totals.step_limits = limits;
  const std::string text =
      summary_text(scene, state, {"out", "deck.xml", "", "1.0", {}}, totals, {}, {}, {});
  EXPECT_NE(text.find("\"growth limit\": {\n      \"share\": 0.25"), std::string::npos) << text;
  EXPECT_NE(text.find("\"shortest\": 2e-08"), std::string::npos) << text;
}

TEST(Summary, CountsAreWholeAndWhatIsNoNumberIsNull) {
  Scene scene = synthetic::make_scene();
  scene.title = "caf\xE9 \x01";  // Latin-1, and a character that JSON escapes
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const State state = synthetic::make_state(scene, comm);
  RunTotals totals = sum_totals(state);
  totals.ledger.kinetic = 0.1;
  totals.ledger.elastic = std::numeric_limits<double>::infinity();
  RunSummary summary;
  summary.warnings = {{"first", 2}, {"second", 1}};
  const std::string text =
      summary_text(scene, state, {"out", "deck.xml", "", "1.0", {}}, totals, {}, summary, {});
  for (const char* word :
       {"\"title\": \"caf\xC3\xA9 \\u0001\",\n",
        "\"particles\": 800,\n",
        "\"kinetic\": 0.1,\n      \"elastic\": null,\n",
        "\"met_target\": false,\n    \"depth\": null,\n",
        "\"phases\": {},\n",
        "\"warnings\": {\n    \"first\": 2,\n    \"second\": 1\n  }\n}\n"})
    EXPECT_NE(text.find(word), std::string::npos) << word << "\n" << text;
}

TEST(Summary, SaysHowWellCellsResolveTheJet) {
  Scene scene = synthetic::make_scene();
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const State state = synthetic::make_state(scene, comm);
  const auto text_with = [&](const Penetration& penetration) {
    return summary_text(
        scene, state, {"out", "deck.xml", "", "1.0", {}}, sum_totals(state), penetration, {}, {}
    );
  };
  EXPECT_NE(text_with({}).find("\"cells_per_radius\": {\n      \"tip\": "), std::string::npos);
  EXPECT_NE(text_with({}).find("\"cells_per_length\": {\n      \"tip\": "), std::string::npos);
  EXPECT_EQ(text_with({}).find("depth_error"), std::string::npos);
  Penetration met;
  met.met = true;
  met.depth = 0.01;
  EXPECT_NE(text_with(met).find("\"depth_error\": {\n      \"unknown\": "), std::string::npos);
  EXPECT_NE(text_with(met).find("\"advice\": \"barreno converge "), std::string::npos);

  // A formed jet, of which nothing was measured.
  scene.jet.present = false;
  BodySpec liner;
  liner.material = 2;
  liner.shape = Box{{0.0, -0.012, 0.0}, {0.004, -0.007, 0.0}};
  scene.bodies.push_back(liner);
  RunDescription run{"out", "deck.xml", "", "1.0", {}};
  run.monitor.bodies = {2};
  run.monitor.position = -5e-3;
  const std::string formed = summary_text(scene, state, run, sum_totals(state), met, {}, {});
  EXPECT_NE(formed.find("\"unknown\": \"it was measured with launched"), std::string::npos)
      << formed;
}

TEST(History, HasAHeaderAndARowThatMatch) {
  const Scene scene = synthetic::make_scene();
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder(*comm);
  const State state = synthetic::make_state(scene, comm);
  const RunTotals totals = sum_totals(state);
  EXPECT_EQ(totals.particles, 800.0);
  HistoryWriter writer(scene, *comm, folder.path() / "history.csv");
  writer.write(*comm, state.clock, totals);
  comm->barrier();
  std::istringstream text(synthetic::read_text(folder.path() / "history.csv"));
  std::string comment, header, row;
  std::getline(text, comment);
  std::getline(text, header);
  std::getline(text, row);
  EXPECT_EQ(comment.substr(0, 1), "#");
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), std::count(row.begin(), row.end(), ','));
}

}  // namespace
}  // namespace barreno
