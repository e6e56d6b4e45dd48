// SPDX-License-Identifier: BSD-3-Clause
#include "check/gap_notes.hpp"
#include "check/jet_lines.hpp"
#include "check/jet_note.hpp"
#include "check/plan.hpp"
#include "check/predict_cost.hpp"
#include "check/scale_notes.hpp"
#include "jet/depth.hpp"
#include "jet/depth_error.hpp"
#include "jet/depth_tables.hpp"
#include "jet/divided_error.hpp"
#include "jet/estimate.hpp"
#include "scene/jet_kinds.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <barreno/models.hpp>
#include <barreno/registry.hpp>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace barreno {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();
constexpr double jet_density = 17600.0, steel_density = 7830.0, rock_density = 2120.0;
constexpr double cell = 1e-3, launch = -5e-3, face = 0.0, border = 12.7e-3, back = 0.3127;

Material rock() {
  Arenisca::Parameters p{};
  p.PEAKI1 = 1e6;
  p.FSLOPE = 0.4;
  p.STREN = 300e6;
  p.YSLOPE = 0.2;
  p.B0 = 10e9;
  p.G0 = 8e9;
  p.p0_crush_curve = -100e6;
  p.p1_crush_curve = 1e-9;
  p.p3_crush_curve = 0.2;
  p.CR = 0.5;
  p.tolerance = 1e-6;
  return {"sandstone", rock_density, Arenisca(p, rock_density)};
}

JohnsonCook::Parameters tungsten_parameters() {
  JohnsonCook::Parameters p;
  p.shear_modulus = 147e9;
  p.a = 1506e6;
  p.b = 176.5e6;
  p.n = 0.12;
  p.melt_temperature = 3695.0;
  p.specific_heat = 135.0;
  p.sound_speed = 3992.0;
  p.slope = 1.23;
  p.gamma = 1.43;
  return p;
}
MaterialSpec tungsten(const JohnsonCook::Parameters& p = tungsten_parameters()) {
  return Material{"tungsten", jet_density, JohnsonCook(p, jet_density)};
}

/// A tungsten jet along +y in front of steel and rock; cells of 1 mm.
Scene jet_scene(std::vector<JetSlug> slugs) {
  Scene scene =
      testing::box_scene(Mode::axisymmetric, cell, {0, -0.04, 0}, {0.08, 0.33, 0}, tungsten());
  scene.materials.push_back(testing::elastic(2e11, 0.3, steel_density));
  scene.materials.emplace_back(rock());
  testing::add_box(scene, "Casing", {0, face, 0}, {0.05, border, 0}, 2).material = 1;
  testing::add_box(scene, "Rock", {0, border, 0}, {0.05, back, 0}, 2).material = 2;
  scene.jet.present = true;
  scene.jet.slugs = std::move(slugs);
  scene.jet.launch_position = launch;
  scene.end_time = 1e-4;
  return scene;
}

JetSlug slug(double time, double velocity, double radius, double length) {
  return {time, velocity, radius, length, jet_density};
}

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}
std::string together(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += note + "\n";
  return text;
}

const DepthTables& tables = depth_tables();

/// Rows of a results file or a table, comments and header left out.
std::vector<std::vector<std::string>> rows_of(const std::string& name) {
  std::ifstream file(std::string(BARRENO_SOURCE_DIR) + "/" + name);
  EXPECT_TRUE(file.good()) << name;
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::vector<std::string> row;
    std::istringstream cells(line);
    for (std::string one; std::getline(cells, one, ',');) row.push_back(one);
    rows.push_back(row);
  }
  rows.erase(rows.begin());
  return rows;
}

Scene main_job() {
  std::vector<JetSlug> slugs;
  for (const auto& row : rows_of("input_xml/jets/tungsten_154.csv"))
    slugs.push_back(slug(std::stod(row[0]), std::stod(row[1]), std::stod(row[2]), std::stod(row[3]))
    );
  Scene scene = jet_scene(slugs);
  scene.end_time = 120e-6;
  return scene;
}

TEST(DepthErrorTable, IsThatOfTheResultsFiles) {
  std::map<std::pair<double, double>, double> depths;
  for (const auto& row : rows_of("verification/results/perforation_cells.csv"))
    depths[{1e-3 * std::stod(row[0]), 1e-6 * std::stod(row[1])}] = 1e-3 * std::stod(row[2]);
  std::size_t compared = 0;
  for (const auto& [where, depth] : depths) {
    for (std::size_t t = 0; t < tables.times.size(); ++t) {
      if (std::abs(tables.times[t] - where.second) > 1e-9) continue;
      for (const MeasuredDepths& row : tables.depths)
        if (std::abs(row.cell - where.first) < 1e-9) {
          EXPECT_NEAR(row.depth[t], depth, 1e-9) << where.first << " " << where.second;
          ++compared;
        }
      if (std::abs(where.first - 0.125e-3) < 1e-9) {
        EXPECT_NEAR(tables.finest[t], depth, 1e-9) << where.second;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, depths.size());
  std::size_t steady = 0;
  for (const auto& row : rows_of("verification/results/steady_penetration.csv")) {
    if (row[2] != "Berea sandstone") continue;
    const SteadyError& one = tables.steady.at(steady++);
    EXPECT_EQ(one.cells_per_radius, std::stod(row[0]));
    EXPECT_NEAR(one.low, 0.01 * std::stod(row[3]), 1e-12);
    EXPECT_NEAR(one.high, 0.01 * std::stod(row[4]), 1e-12);
  }
  EXPECT_EQ(steady, tables.steady.size());
}

TEST(DepthError, GivesBackWhatWasMeasuredAndLiesBetween) {
  // perforation_120us.xml with cells of 1 mm at 50 us: 159.2 mm instead of 180.4 mm.
  const double at_50 = 159.2 / 180.4 - 1.0;
  EXPECT_NEAR(measured_depth_error(tables, 1.0, 159.2).value, at_50, 1e-12);
  EXPECT_NEAR(measured_depth_error(tables, 1.0, 149.25, DepthOf::estimate).value, at_50, 1e-4);
  const DepthError one = measured_depth_error(tables, 1.0, 1000.0);
  EXPECT_NEAR(one.value, 232.3 / 271.5 - 1.0, 1e-12);
  EXPECT_NEAR(one.low, -0.15, 1e-12);
  EXPECT_NEAR(one.high, -0.03, 1e-12);
  const DepthError coarse = measured_depth_error(tables, 0.5, 271.5);
  EXPECT_NEAR(coarse.low, 13.87 / 20.74 - 1.0, 1e-12);  // beyond that of steady penetration
  EXPECT_EQ(measured_depth_error(tables, 4.0, 100.0).value, 0.0);
  EXPECT_NEAR(measured_depth_error(tables, 4.0, 100.0).high, 20.74 / 20.45 - 1.0, 1e-12);
  const double middle = measured_depth_error(tables, std::sqrt(0.5), 1000.0).value;
  EXPECT_NEAR(middle, 0.5 * ((232.3 + 182.6) / 271.5 - 2.0), 1e-12);
  EXPECT_EQ(depth_error_text({-0.137, -0.15, 0.0049}), "-14 % (-15 to 0 %)");
}

TEST(LengthErrors, AreThoseOfTheResultsFile) {
  std::ifstream file(BARRENO_SOURCE_DIR "/verification/results/slug_length.json");
  const auto data = nlohmann::json::parse(file);
  std::size_t compared = 0;
  for (const auto& row : data["rows"])
    for (const LengthError& one : tables.lengths)
      for (std::size_t n = 0; n < tables.length_cells.size(); ++n) {
        const bool same = std::abs(one.length_over_radius / row[1].get<double>() - 1.0) < 1e-4 &&
                          tables.length_cells[n] == row[2].get<double>();
        if (!same) continue;
        EXPECT_NEAR(one.error[n], row[5].get<double>(), 0.51e-4) << row[0] << " " << row[2];
        ++compared;
      }
  EXPECT_EQ(compared, tables.lengths.size() * tables.length_cells.size());
}

TEST(DepthError, ChangesWithTheLengthOfTheSlugs) {
  const DepthError one{-0.07, -0.15, -0.03};
  const auto change = [&](double cells, double length) {
    return with_length(tables, one, cells, length).value - one.value;
  };
  const LengthError &shortest = tables.lengths.front(), &longest = tables.lengths.back();
  const LengthError& usual = tables.lengths[tables.own_length];
  for (const double cells : {0.5, 1.0, 2.0, 4.0})
    EXPECT_NEAR(change(cells, usual.length_over_radius), 0.0, 1e-15) << cells;
  for (std::size_t n = 0; n < tables.length_cells.size(); ++n)
    for (const LengthError& other : {shortest, longest})
      EXPECT_NEAR(
          change(tables.length_cells[n], other.length_over_radius),
          other.error[n] - usual.error[n],
          1e-15
      );
  EXPECT_EQ(change(1.0, 10.0), change(1.0, longest.length_over_radius));
  EXPECT_EQ(change(0.5, 10.0), change(1.0, 10.0));
  EXPECT_EQ(change(4.0, longest.length_over_radius), 0.0);
  const double half_way = std::sqrt(usual.length_over_radius * longest.length_over_radius);
  EXPECT_NEAR(change(1.0, half_way), 0.5 * change(1.0, 10.0), 1e-15);
  const DepthError better = with_length(tables, one, 1.0, 10.0);
  EXPECT_EQ(better.low, one.low);
  EXPECT_EQ(better.high, one.high + change(1.0, 10.0));

  Scene scene = jet_scene({slug(0, 7000, 1e-3, 0.4e-3)});
  EXPECT_TRUE(says(depth_doubt(scene, 1e-5).unknown, "at least half as long as their radius"));
  scene.jet.slugs[0].length = 0.6e-3;
  EXPECT_EQ(depth_doubt(scene, 1e-5).unknown, "");
  EXPECT_NEAR(depth_doubt(scene, 1e-5).cells_per_length, 0.6, 1e-12);
}

TEST(DepthDoubt, IsUnknownBeyondWhatWasMeasured) {
  const Scene scene = main_job();
  EXPECT_EQ(depth_doubt(scene, 90e-6).unknown, "");
  EXPECT_TRUE(says(depth_doubt(scene, 91e-6).unknown, "until 90 us only"));
  EXPECT_TRUE(says(depth_doubt(scene, 330e-6, 0.357).unknown, "until 90 us only"));
  // The end of a run is met with a rounding.
  EXPECT_EQ(depth_doubt(scene, 90e-6 * (1.0 + 1e-9), 0.265).unknown, "");
  EXPECT_TRUE(says(depth_doubt(scene, 90e-6, 0.3).unknown, "to a depth of 271.5 mm only"));

  // Lengths and times scale: a jet of half the radius is known half as long.
  EXPECT_EQ(why_reach_unknown(tables, 45e-6, 0.5e-3, 7830.0, 0.13), "");
  EXPECT_TRUE(says(why_reach_unknown(tables, 46e-6, 0.5e-3, 7830.0, 0.13), "until 45 us only"));
  EXPECT_TRUE(
      says(why_reach_unknown(tables, 45e-6, 0.5e-3, 7830.0, 0.15), "to a depth of 135.8 mm only")
  );
  EXPECT_TRUE(says(why_reach_unknown(tables, 1e-6, 1e-3, 4000.0, 0.0), "a tip of 7830 m/s only"));
}

/// Until the measurements end, no slug was slower and no gap wider.
TEST(DepthDoubt, IsUnknownOfSlowerSlugsAndWiderGaps) {
  const JetEstimate measured = estimate_jet(main_job(), tables.times.back());
  EXPECT_NEAR(measured.slowest, measured_slowest, 0.1);
  EXPECT_NEAR(measured.least_filled, measured_least_filled, 0.005);

  Scene slow = jet_scene({slug(0, 7000, 1e-3, 1e-3), slug(0.2e-6, 2000, 1e-3, 1e-3)});
  EXPECT_EQ(depth_doubt(slow, 2e-6).unknown, "");  // the second one has not arrived
  EXPECT_TRUE(says(depth_doubt(slow, 10e-6).unknown, "slugs faster than 3093 m/s only"));
  slow.jet.slugs[1].velocity = 2500.0;
  EXPECT_EQ(depth_doubt(slow, 10e-6).unknown, "");

  Scene thin = jet_scene({slug(0, 7000, 1e-3, 1e-3), slug(0.6e-6, 7000, 1e-3, 1e-3)});
  EXPECT_TRUE(says(depth_doubt(thin, 10e-6).unknown, "at least 0.39 of their flight only"));
  thin.jet.slugs[1].time = 0.4e-6;
  EXPECT_EQ(depth_doubt(thin, 10e-6).unknown, "");
}

TEST(DepthDoubt, IsUnknownOfAFormedJetAndSaysWhatToDo) {
  Scene formed = main_job();
  formed.jet = {};
  Penetration found;
  found.met = true;
  found.depth = 0.01;
  const DepthDoubt doubt = depth_doubt(formed, 10e-6, found);
  const std::string text = depth_doubt_text(doubt);
  EXPECT_TRUE(says(text, "unknown (it was measured with launched jets only); barreno converge"))
      << text;
  EXPECT_EQ(depth_doubt(main_job(), 10e-6, found).unknown, "");

  // Its plan says the same if it meets a target.
  BodySpec liner = formed.bodies.front();
  liner.shape = Box{{0.0, -0.03, 0.0}, {0.004, -0.02, 0.0}};
  formed.bodies.push_back(liner);
  JetMonitorSpec monitor;
  monitor.bodies = {2};
  monitor.position = -10e-3;
  EXPECT_TRUE(says(
      jet_lines(formed, monitor),
      "Depth     expected error at the end from the size "
      "of the cells: unknown (it was measured with launched"
  )) << jet_lines(formed, monitor);
  EXPECT_EQ(jet_lines(formed), "");
}

TEST(DepthError, IsUnknownWithAnotherMethodContactOrFailure) {
  const Scene scene = jet_scene({slug(0, 7000, 1e-3, 1e-3)});
  const auto unknown = [&](const auto& change) {
    Scene other = scene;
    change(other);
    return why_depth_error_unknown(tables, other, 1.0);
  };
  EXPECT_EQ(unknown([](Scene&) {}), "");
  EXPECT_TRUE(says(unknown([](Scene& s) { s.step.shape = "CPDI"; }), "Shape Function GIMP only"));
  EXPECT_TRUE(
      says(unknown([](Scene& s) { s.step.order = Order::stress_first; }), "Order stress last only")
  );
  EXPECT_TRUE(says(unknown([](Scene& s) { s.step.return_losses = true; }), "Return Losses"));
  ContactSpec contact;
  contact.materials = {1, 2};
  EXPECT_EQ(unknown([&](Scene& s) { s.contacts = {contact}; }), "");
  contact.materials = {2, 0};
  EXPECT_TRUE(says(unknown([&](Scene& s) { s.contacts = {contact}; }), "without contact of the"));
  const auto with_metal = [&](const auto& change) {
    JohnsonCook::Parameters p = tungsten_parameters();
    change(p);
    return unknown([&](Scene& s) { s.materials[0] = tungsten(p); });
  };
  EXPECT_EQ(with_metal([](auto&) {}), "");
  const char* const failure = "not with the Spall Stress or damage of tungsten";
  EXPECT_TRUE(says(with_metal([](auto& p) { p.spall_stress = 2e9; }), failure));
  EXPECT_TRUE(says(with_metal([](auto& p) { p.d2 = 0.33; }), failure));
  EXPECT_TRUE(says(
      unknown([](Scene& s) { s.materials[0] = testing::elastic(4e11, 0.28, jet_density); }),
      "not with elastic in sandstone"
  ));
}

TEST(DepthError, IsUnknownWhereNothingWasMeasured) {
  const Scene scene = jet_scene({slug(0, 7000, 1e-3, 1e-3)});
  EXPECT_EQ(why_depth_error_unknown(tables, scene, 1.0), "");
  EXPECT_TRUE(says(why_depth_error_unknown(tables, scene, 0.4), "0.5 to 4 cells per radius"));
  EXPECT_TRUE(says(why_depth_error_unknown(tables, scene, 5.0), "0.5 to 4 cells per radius"));
  Scene other = scene;
  other.grid.mode = Mode::plane_strain;
  EXPECT_TRUE(says(why_depth_error_unknown(tables, other, 1.0), "round jets"));
  other = scene;
  other.step.transfer = Transfer::apic;
  EXPECT_TRUE(says(why_depth_error_unknown(tables, other, 1.0), "FLIP"));
  other = scene;
  other.bodies[1].material = 1;
  EXPECT_TRUE(says(why_depth_error_unknown(tables, other, 1.0), "not with tungsten in elastic"));
  other = scene;
  other.materials[0] = testing::copper();
  EXPECT_TRUE(says(why_depth_error_unknown(tables, other, 1.0), "not with copper in sandstone"));
}

TEST(JetEstimate, IsHydrodynamicInEveryLayer) {
  const double length = 5e-3, velocity = 7000.0, k = std::sqrt(steel_density / jet_density);
  const Scene scene = jet_scene({slug(1e-6, velocity, 1e-3, length)});
  const JetEstimate whole = estimate_jet(scene, forever);
  EXPECT_NEAR(whole.depth, length / k, 1e-12);
  EXPECT_EQ(whole.mass_left, 0.0);
  const double arrival = 1e-6 + (face - launch - 0.5 * length) / velocity;
  const double digging = length * (1.0 + k) / (velocity * k);
  EXPECT_NEAR(whole.time, arrival + digging, 1e-15);
  const JetEstimate half = estimate_jet(scene, arrival + 0.5 * digging);
  EXPECT_NEAR(half.mass_left, 0.5, 1e-9);
  EXPECT_NEAR(half.depth, 0.5 * length / k, 1e-12);
  EXPECT_EQ(estimate_jet(scene, 0.9 * arrival).thinnest, 0.0);

  // What the casing leaves digs in the rock.
  const double longer = 0.03, rest = longer - border * k;
  const Scene deep = jet_scene({slug(0, velocity, 1e-3, longer)});
  EXPECT_NEAR(
      estimate_jet(deep, forever).depth,
      border + rest / std::sqrt(rock_density / jet_density),
      1e-12
  );
  const JetEstimate passed = estimate_jet(jet_scene({slug(0, velocity, 1e-3, 1.0)}), forever);
  EXPECT_TRUE(passed.passed);
  EXPECT_NEAR(passed.depth, back - face, 1e-12);
}

TEST(JetEstimate, FallsShortOfTheMainJobAsItsCommentSays) {
  const Scene scene = main_job();
  const MeasuredDepths& finest = tables.depths.back();
  for (std::size_t t = 0; t < tables.times.size(); ++t)
    EXPECT_NEAR(estimate_jet(scene, tables.times[t]).depth, tables.estimated[t], 1e-5);
  EXPECT_NEAR(estimate_jet(scene, 10e-6).depth / finest.depth[1], 0.97, 0.01);
  EXPECT_NEAR(estimate_jet(scene, 90e-6).depth / finest.depth[6], 0.74, 0.01);
}

TEST(JetLines, SayCellsOfTipAndTailAndTheErrorToExpect) {
  const std::string text = jet_lines(main_job());
  EXPECT_TRUE(says(text, "154 slugs of 7830 to 1292 m/s")) << text;
  EXPECT_TRUE(says(text, "1 to 2.2 cells per radius (tip 1, tail 2.2)")) << text;
  EXPECT_TRUE(says(text, "0.302 to 1.01 cells per length (tip 1.01, tail 0.302)")) << text;
  // It ends later than any error was measured.
  EXPECT_TRUE(says(text, "the cells: unknown (it was measured until 90 us only); barreno converge"))
      << text;
  // As it was measured with cells of 1 mm.
  for (const auto& [time, error] : std::map<double, std::string>{
           {10e-6, "-7 %"},
           {20e-6, "-9 %"},
           {30e-6, "-10 %"},
           {50e-6, "-12 %"},
           {90e-6, "-14 %"}}) {
    Scene shorter = main_job();
    shorter.end_time = time;
    EXPECT_TRUE(says(jet_lines(shorter), "the cells: " + error + " (")) << jet_lines(shorter);
  }
  Scene coarse = main_job();
  coarse.end_time = 90e-6;
  coarse.grid.cell_size = 2e-3;
  EXPECT_TRUE(says(jet_lines(coarse), "(-33 to -16 %) at 0.5 cells per jet radius"));
  coarse.grid.cell_size = 4e-3;
  EXPECT_TRUE(says(jet_lines(coarse), "unknown (it was measured with 0.5 to 4 cells"));
  coarse.jet.present = false;
  EXPECT_EQ(jet_lines(coarse), "");
}

TEST(JetLines, SayTheKindAndWhatFollows) {
  Scene scene = main_job();
  scene.jet.table = scene.jet.slugs;
  const char* const filled = "metal fills 0.463 of the jet's length, at least 0.166 of a slug's";
  EXPECT_TRUE(
      says(jet_lines(scene), std::string("Kind      discrete: ") + filled + ", the rest are")
  );
  const auto text_of_kind = [&](JetKind kind) {
    scene.jet.kind = kind;
    scene.jet.slugs = slugs_of_kind(scene.jet.table, kind, scene.grid.mode, jet_density);
    return jet_lines(scene);
  };
  const std::string thinned = text_of_kind(JetKind::thinned);
  EXPECT_TRUE(says(thinned, std::string("Kind      thinned: ") + filled)) << thinned;
  EXPECT_TRUE(says(thinned, "depth 2.16 times that of the discrete jet")) << thinned;
  EXPECT_TRUE(says(thinned, "unknown (it was measured with discrete jets only)")) << thinned;
  const std::string continuous = text_of_kind(JetKind::continuous);
  EXPECT_TRUE(says(continuous, "depth 1.72 times that of the discrete jet")) << continuous;
}

/// A whole jet digs on where the discrete one has gaps.
TEST(JetEstimate, FollowsTheHydrodynamicRuleOfTheKinds) {
  std::vector<JetSlug> table;
  for (int s = 0; s < 4; ++s) {
    table.push_back(slug(2e-6 * s, 1000.0, 2e-3, 2e-3));
    table.back().density = jet_density / 2.0;
  }
  const auto depth_of = [&](JetKind kind) {
    Scene scene = jet_scene(slugs_of_kind(table, kind, Mode::axisymmetric, jet_density));
    scene.jet.kind = kind;
    return estimate_jet(scene, 1.0).depth;
  };
  const double discrete = depth_of(JetKind::discrete), thinned = depth_of(JetKind::thinned);
  // Of two layers the rule holds in the first.
  ASSERT_LT(thinned, border - face);
  EXPECT_NEAR(thinned / discrete, 2.0, 1e-12);
  EXPECT_NEAR(depth_of(JetKind::continuous) / discrete, std::sqrt(3.0), 1e-12);
}

TEST(JetNote, NamesAJetThatMissesOrOnlyGrazes) {
  Scene scene = jet_scene({slug(0, 7000, 1e-3, 1e-3), slug(0, 6000, 3e-3, 1e-3)});
  EXPECT_EQ(jet_note(scene), "");
  for (BodySpec& body : scene.bodies) std::get<Box>(body.shape).lower[0] = 2e-3;
  EXPECT_TRUE(says(jet_note(scene), "the thinnest slugs of the jet hit no body along +y"));
  for (BodySpec& body : scene.bodies) std::get<Box>(body.shape).lower[0] = 4e-3;
  EXPECT_TRUE(says(jet_note(scene), "the jet hits no body"));
  scene = jet_scene({slug(2e-4, 7000, 1e-3, 1e-3)});
  EXPECT_TRUE(says(jet_note(scene), "not before Time/End Time"));
}

TEST(JetNote, NamesAnEndBeforeTheJetStops) {
  const std::string note = early_end_note(main_job());
  EXPECT_TRUE(says(note, "Time/End Time = 0.00012 s ends the run before the jet stops (32 %"))
      << note;
  EXPECT_TRUE(says(note, "an End Time of about 0.0003 s")) << note;
  Scene done = main_job();
  done.end_time = 4e-4;
  EXPECT_EQ(early_end_note(done), "");
  Scene thin = main_job();
  std::get<Box>(thin.bodies[1].shape).upper[1] = 0.1;
  EXPECT_EQ(early_end_note(thin), "");  // the jet is through
  EXPECT_TRUE(says(through_note(thin), "comes out of the rear of the target"))
      << through_note(thin);
  EXPECT_EQ(through_note(done), "");
  thin.end_time = 15e-6;
  EXPECT_TRUE(says(early_end_note(thin), "when the jet comes out of the back"));
  Scene late = main_job();
  late.end_time = 1e-9;  // jet_note says it
  EXPECT_EQ(early_end_note(late), "");
}

TEST(GapNotes, NameBodiesThatDoNotTouch) {
  Scene scene = jet_scene({slug(0, 7000, 1e-3, 1e-3)});
  EXPECT_EQ(together(gap_notes(scene)), "");
  std::get<Box>(scene.bodies[1].shape).lower[1] = border + 0.3e-3;
  const std::string note = together(gap_notes(scene));
  EXPECT_TRUE(says(note, "Bodies/Rock and Bodies/Casing do not touch in the path of the jet"))
      << note;
  EXPECT_TRUE(says(note, "a gap of 0.0003 m or 0.3 cells")) << note;
  scene.jet.present = false;
  EXPECT_TRUE(says(together(gap_notes(scene)), "are at rest 0.0003 m apart, 0.3 cells"));
  scene.bodies[1].velocity[1] = -1.0;  // they are to meet
  EXPECT_EQ(together(gap_notes(scene)), "");
  scene.bodies[1].velocity[1] = 0.0;
  std::get<Box>(scene.bodies[1].shape).lower[1] = border + 1.5 * cell;
  EXPECT_EQ(together(gap_notes(scene)), "");
  std::get<Box>(scene.bodies[1].shape).lower = {0.0504, border + 0.3e-3, 0};  // round a corner
  EXPECT_EQ(together(gap_notes(scene)), "");
}

TEST(ScaleNotes, AreSilentOnTheMainJob) {
  EXPECT_EQ(together(scale_notes(main_job())), "");
}

TEST(ScaleNotes, NameWhatLooksLikeAForgottenUnit) {
  Scene scene = jet_scene({slug(0, 7.83, 1e-3, 1e-3)});
  EXPECT_TRUE(says(together(scale_notes(scene)), "Jet/Slugs gives the fastest slug 7.83 m/s"));
  EXPECT_TRUE(says(together(scale_notes(scene)), "the deck's Units"));
  scene.jet.slugs = {slug(0, 7830, 1.0, 1e-3)};
  scene.jet.table_file = "jet.csv";
  EXPECT_TRUE(says(together(scale_notes(scene)), "Jet/Table gives a slug a radius of 1 m"));
  EXPECT_TRUE(says(together(scale_notes(scene)), "# units: mm-us-g"));
  scene = jet_scene({slug(0, 7830, 1e-3, 1e-3)});
  std::get<Box>(scene.bodies[1].shape).upper[1] = 40.0;
  EXPECT_TRUE(says(together(scale_notes(scene)), "the target is 40 m thick along the jet"));
  scene = jet_scene({slug(0, 7830, 1e-3, 1e-3)});
  scene.grid.cell_size = 20e-3;
  const std::string thin = together(scale_notes(scene));
  EXPECT_TRUE(says(thin, "Bodies/Casing is 0.0127 m thick, less than a cell")) << thin;
  scene = jet_scene({slug(0, 7830, 1e-3, 1e-3)});
  scene.end_time = 120.0;
  EXPECT_TRUE(says(together(scale_notes(scene)), "Time/End Time = 120 s takes"));
}

TEST(PredictCost, SeesTheSpeedThatALongWaveHasInItsBody) {
  Scene scene = jet_scene({slug(0, 7000, 1e-3, 1e-3)});
  scene.jet.present = false;
  const double at_rest = stable_step_of_scene(scene, false);
  scene.bodies[0].velocity = {0.0, 1e7, 0.0};
  EXPECT_LT(stable_step_of_scene(scene, false), 0.01 * at_rest);
  scene.bodies[0].velocity_wave_number = {0.0, 1e-6, 0.0};  // 10 1/s times y
  EXPECT_NEAR(stable_step_of_scene(scene, false), at_rest, 1e-3 * at_rest);
}

/// A jet like that of perforation.xml, with divided particles.
Scene divided_scene() {
  Scene scene = jet_scene({slug(0, 7830, 1e-3, 0.55e-3), slug(1.2e-6, 600, 2.2e-3, 0.17e-3)});
  JohnsonCook::Parameters p = tungsten_parameters();
  p.spall_stress = 2e9;
  scene.materials[0] = tungsten(p);
  scene.jet.splits = 4;
  scene.jet.particles_per_cell = 2;
  scene.jet.cells_per_radius = 1.8;
  scene.grid.cell_size = 1e-3 / 1.8;
  scene.bodies[1].shape = Box{{0, border, 0}, {0.05, 1.0, 0}};
  scene.bodies[1].initial_pressure = 69e6;
  scene.end_time = 400e-6;
  return scene;
}

TEST(DividedError, IsThatOfTheTableAndBetweenItsCells) {
  const DividedError &coarse = tables.divided[0], &fine = tables.divided[1];
  Penetration found;
  found.met = true;
  found.depth = found.probed_depth = 0.3;
  Scene scene = divided_scene();
  const auto with_cells = [&](double cells) {
    scene.grid.cell_size = 1e-3 / cells;
    return depth_doubt(scene, 200e-6, found);
  };
  EXPECT_EQ(with_cells(1.8).unknown, "");
  for (const DividedError* one : {&coarse, &fine}) {
    const DepthDoubt depth = with_cells(one->cells_per_radius);
    EXPECT_NEAR(depth.error.low, one->depth.low, 1e-9);
    EXPECT_NEAR(depth.error.high, one->depth.high, 1e-9);
    const DepthDoubt probed = probed_depth_doubt(scene, 200e-6, found);
    EXPECT_EQ(probed.unknown, "");
    EXPECT_NEAR(probed.error.value, one->probed.value, 1e-9);
    EXPECT_NEAR(probed.error.low, one->probed.low, 1e-9);
    const DepthDoubt volume = volume_doubt(scene, 200e-6, found);
    EXPECT_EQ(volume.unknown, "");
    EXPECT_NEAR(volume.error.high, one->volume.high, 1e-9);
    Scene bare = scene;
    bare.bodies[1].initial_pressure = 0.0;
    EXPECT_TRUE(says(volume_doubt(bare, 200e-6, found).unknown, "of 34 MPa and more only"));
  }
  const DepthDoubt middle = with_cells(std::sqrt(coarse.cells_per_radius * fine.cells_per_radius));
  EXPECT_NEAR(middle.error.value, 0.5 * (coarse.depth.value + fine.depth.value), 1e-9);
}

/// Of a hole at rest, in rock that says how far its grains are broken.
TEST(DividedError, OfTheCoreFlowEfficiencyIsThatOfHolesAtRest) {
  Scene scene = divided_scene();
  Penetration found;
  found.met = true;
  const DividedError& first = tables.divided.front();
  scene.grid.cell_size = 1e-3 / first.cells_per_radius;
  const auto unknown = [&](double time) { return efficiency_doubt(scene, time, found).unknown; };
  EXPECT_TRUE(says(unknown(400e-6), "(Breakage energy)"));
  const auto take_card = [&](const std::string& name) {
    std::ifstream card(std::string(BARRENO_SOURCE_DIR) + "/materials/cards/" + name);
    const std::string text{std::istreambuf_iterator<char>(card), {}};
    scene.materials[static_cast<std::size_t>(scene.bodies[1].material)] =
        make_material("Rock", scan_card(text, name));
  };
  take_card("berea_sandstone_damage.xml");
  EXPECT_TRUE(says(unknown(400e-6), "a Broken dilatancy of 1 and a Damage pressure of 1 GPa only"));
  take_card("berea_sandstone_heat.xml");
  EXPECT_EQ(unknown(400e-6), "");
  EXPECT_EQ(efficiency_doubt(scene, 372e-6, found).error.low, first.efficiency.low);
  EXPECT_TRUE(says(unknown(120e-6), "at 400 us only"));
  found.through = true;
  EXPECT_TRUE(says(unknown(400e-6), "out of the rear"));
  found.through = false;
  scene.bodies[1].initial_pressure = 0.0;
  EXPECT_TRUE(says(unknown(400e-6), "of 34 MPa and more only"));
}

TEST(DividedError, OfTheDepthEndsWithTheMeasurementsAndThatOfTheWideHoleDoesNot) {
  const Scene scene = divided_scene();
  Penetration found;
  found.met = true;
  EXPECT_EQ(depth_doubt(scene, 400e-6, found).unknown, "");
  Scene to_rest = scene;
  to_rest.at_rest = true;
  to_rest.end_time = 1e-3;
  to_rest.grid.cell_size = 1e-3 / tables.divided.front().cells_per_radius;
  EXPECT_EQ(depth_doubt(to_rest, 400e-6, found).error.low, tables.divided.front().depth.low);
  EXPECT_EQ(depth_doubt(to_rest, 500e-6, found).error.low, tables.divided.front().resting.low);
  EXPECT_TRUE(says(depth_doubt(to_rest, 1e-3, found).unknown, "until 400 us and at rest only"))
      << "the longest time has ended it";
  EXPECT_TRUE(says(depth_doubt(scene, 401e-6, found).unknown, "until 400 us and at rest only; what")
  );
  EXPECT_EQ(probed_depth_doubt(scene, 560e-6, found).unknown, "");
  found.through = true;
  EXPECT_TRUE(says(probed_depth_doubt(scene, 560e-6, found).unknown, "out of the rear"));
  EXPECT_TRUE(says(volume_doubt(scene, 400e-6, found).unknown, "out of the rear"));
}

/// The measured jet itself is known; jets a fifth away, or with gaps ten times as long, are not.
TEST(DividedError, IsThatOfTheJetOfTheDeck) {
  Scene scene = divided_scene();
  scene.jet.slugs.clear();
  for (const auto& row : rows_of("input_xml/jets/tungsten_320.csv"))
    scene.jet.slugs.push_back(
        {std::stod(row[0]), std::stod(row[1]), std::stod(row[2]), std::stod(row[3]), jet_density}
    );
  const auto unknown = [&](const auto& change) {
    Scene other = scene;
    for (JetSlug& one : other.jet.slugs) change(one);
    return depth_doubt(other, 240e-6, 0.4).unknown;
  };
  EXPECT_EQ(unknown([](JetSlug&) {}), "");
  EXPECT_TRUE(says(unknown([](JetSlug& s) { s.velocity *= 1.2; }), "a tip of 7830 m/s"));
  EXPECT_TRUE(says(unknown([](JetSlug& s) { s.radius *= 1.2; }), "a radius of 1 mm"));
  EXPECT_TRUE(says(unknown([](JetSlug& s) { s.length *= 0.8; }), "0.55 times as long"));
  EXPECT_TRUE(says(unknown([](JetSlug& s) { s.time *= 10.0; }), "of their flight only"));
}

TEST(DividedError, IsUnknownOfOtherJets) {
  const auto unknown = [](const auto& change) {
    Scene scene = divided_scene();
    change(scene);
    return probed_depth_doubt(scene, 200e-6, Penetration{}).unknown;
  };
  EXPECT_EQ(unknown([](Scene&) {}), "");
  EXPECT_TRUE(says(unknown([](Scene& s) { s.jet.splits = 3; }), "divided 4 times only"));
  EXPECT_TRUE(says(unknown([](Scene& s) { s.jet.particles_per_cell = 4; }), "with 2 per cell only")
  );
  EXPECT_TRUE(
      says(unknown([](Scene& s) { s.jet.slugs.front().velocity = 6000; }), "a tip of 7830 m/s only")
  );
  EXPECT_TRUE(
      says(unknown([](Scene& s) { s.jet.slugs.front().radius = 0.7e-3; }), "a radius of 1 mm")
  );
  EXPECT_TRUE(says(
      unknown([](Scene& s) { s.jet.slugs.front().length = 1e-3; }), "0.55 times as long as their"
  ));
  EXPECT_TRUE(says(unknown([](Scene& s) { s.grid.cell_size = 1e-3; }), "cells per radius only"));
  EXPECT_TRUE(
      says(unknown([](Scene& s) { s.jet.kind = JetKind::continuous; }), "discrete jets only")
  );
  EXPECT_TRUE(says(unknown([](Scene& s) { s.step.shape = "CPDI"; }), "Shape Function GIMP only"));
}

}  // namespace
}  // namespace barreno
