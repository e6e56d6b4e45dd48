// SPDX-License-Identifier: BSD-3-Clause
// Costs and errors of depths come from files; where a file or row is missing or broken they are
// unknown, with the reason, and never another number.
#include "check/cost_tables.hpp"
#include "check/plan.hpp"
#include "check/predict_cost.hpp"
#include "check/update_row.hpp"
#include "jet/depth_tables.hpp"
#include "jet/estimate.hpp"
#include "jet/range_effects.hpp"
#include "output/result_numbers.hpp"
#include "state/bodies/body_particles.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <unistd.h>

namespace barreno {
namespace {

namespace fs = std::filesystem;

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

/// A copy of the measured numbers that is there while the object is.
class Copy {
public:
  Copy() { fs::copy(fs::path(BARRENO_SOURCE_DIR) / "src" / "measured", folder_); }
  ~Copy() { fs::remove_all(folder_); }
  Copy(const Copy&) = delete;
  Copy& operator=(const Copy&) = delete;
  const fs::path& folder() const { return folder_; }

  void remove(const std::string& name) const { fs::remove(folder_ / name); }
  /// Another text in place of what must be there.
  void replace(const std::string& name, const std::string& what, const std::string& other) const {
    std::ifstream file(folder_ / name);
    std::ostringstream text;
    text << file.rdbuf();
    std::string changed = text.str();
    const std::size_t at = changed.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    std::ofstream(folder_ / name) << changed.replace(at, what.size(), other);
  }

private:
  fs::path folder_ = fs::temp_directory_path() / ("barreno_measured_" + std::to_string(getpid()));
};

const char* const cost_files[] = {"update_costs.csv", "cost_factors.csv"};
const char* const depth_files[] = {
    "depths_of_cells.csv", "steady_errors.csv", "length_errors.csv", "divided_errors.csv"};

TEST(MeasuredNumbers, RangesOfRockAreInstalledInWhole) {
  const RangeEffects& effects = range_effects();
  EXPECT_EQ(effects.problem, "");
  ASSERT_GE(effects.rows.size(), 11U);
  EXPECT_EQ(effects.rows[0].card, "berea_sandstone_bounded");
  EXPECT_EQ(effects.rows[0].parameter, "STREN");
  EXPECT_EQ(effects.rows[0].range, "96.37 MPa to 430.7 MPa");
  EXPECT_EQ(effects.rows[0].known, "fitted");
  EXPECT_EQ(effects.rows[0].until, "300 us");
  EXPECT_LT(effects.rows[0].volume.at_high, -0.3);
  EXPECT_GT(effects.rows[0].volume.at_low, 0.05);
  const Copy copy;
  copy.replace("range_effects.csv", "berea_sandstone_bounded; STREN; ", "STREN; ");
  EXPECT_TRUE(says(read_range_effects(copy.folder()).problem, "is no card, parameter, range"));
  copy.replace("range_effects.csv", "# end of", "# end after");
  EXPECT_TRUE(says(read_range_effects(copy.folder()).problem, "cannot be used"));
  copy.remove("range_effects.csv");
  EXPECT_TRUE(says(read_range_effects(copy.folder()).problem, "are not installed"));
}

TEST(MeasuredNumbers, AreInstalledInWhole) {
  EXPECT_EQ(cost_tables().problem, "");
  EXPECT_EQ(depth_tables().problem, "");
  EXPECT_EQ(cost_tables().updates.size(), 24U);
  EXPECT_EQ(cost_tables().updates.at("update_stress Arenisca").running, 208.0);
  EXPECT_TRUE(cost_tables().updates.at("update_stress Arenisca general, bisection").is_early);
  EXPECT_EQ(cost_tables().domains, 1.6);
  EXPECT_EQ(cost_tables().rotations, 1.8);
  EXPECT_EQ(cost_tables().nodes_of_parts, 5.0);
  EXPECT_EQ(cost_tables().parts_of_flight, 0.75);
  EXPECT_EQ(cost_tables().field_nanoseconds, 350.0);
  EXPECT_EQ(cost_tables().row_nanoseconds, 12.0);
  const DepthTables& tables = depth_tables();
  EXPECT_EQ(tables.times, (std::vector<double>{5e-6, 10e-6, 20e-6, 30e-6, 50e-6, 70e-6, 90e-6}));
  ASSERT_EQ(tables.depths.size(), 4U);
  EXPECT_EQ(
      tables.depths[0].depth,
      (std::vector<double>{13.87e-3, 33.18e-3, 65.9e-3, 0.0, 132.9e-3, 0.0, 182.6e-3})
  );
  EXPECT_EQ(tables.finest[3], 119.93e-3);
  EXPECT_EQ(tables.steady[1].low, -0.15);
  EXPECT_EQ(tables.lengths[tables.own_length].length_over_radius, 1.00683761);
}

TEST(MeasuredNumbers, AMissingFileMeansThatNothingIsKnown) {
  for (const char* name : cost_files) {
    const Copy copy;
    copy.remove(name);
    const CostTables tables = read_cost_tables(copy.folder());
    EXPECT_EQ(
        tables.problem, "the measured numbers of " + std::string(name) + " are not installed"
    );
    EXPECT_TRUE(tables.updates.empty());
  }
  for (const char* name : depth_files) {
    const Copy copy;
    copy.remove(name);
    const DepthTables tables = read_depth_tables(copy.folder());
    EXPECT_EQ(
        tables.problem, "the measured numbers of " + std::string(name) + " are not installed"
    );
    EXPECT_TRUE(tables.depths.empty());
  }
}

TEST(MeasuredNumbers, ABrokenOrMissingRowMeansThatNothingIsKnown) {
  const std::string rows[][3] = {
      {"update_costs.csv",
       "update_stress Arenisca wet,82,330,0",
       "update_stress Arenisca wet,82,x,0"},
      {"update_costs.csv", "update_stress Arenisca wet,82,330,0\n", ""},
      {"update_costs.csv", "wet,82,330", "wet,82,30"},  // less and less
      {"update_costs.csv", "Arenisca scattered,", "Arenisca wet,"},
      {"cost_factors.csv", "domains,1.6\n", ""},
      {"cost_factors.csv", "domains,1.6", "domain,1.6"},
      {"cost_factors.csv", "rotations,1.8", "rotations,-1.8"}};
  for (const auto& [name, what, other] : rows) {
    const Copy copy;
    copy.replace(name, what, other);
    EXPECT_TRUE(says(read_cost_tables(copy.folder()).problem, "cannot be used")) << what;
  }
  const std::string depths[][3] = {
      {"depths_of_cells.csv", "run,0.00025,0.00005,0.1804", "run,0.00025,0.00005,0"},
      {"depths_of_cells.csv", "run,0.00025,0.00005,0.1804\n", ""},
      {"depths_of_cells.csv", "estimate,0,0.00009,0.19963", "estimated,0,0.00009,0.19963"},
      {"depths_of_cells.csv", "finest,0.000125,0.00003,", "finest,0.000125,0.00004,"},
      {"steady_errors.csv", "sandstone,1,", "sandstone,1.5,"},
      {"length_errors.csv", "as in the table,1.00683761,1,", "as in the table,1.00683761,2,"},
      {"length_errors.csv", "as in the table", "others"}};
  for (const auto& [name, what, other] : depths) {
    const Copy copy;
    copy.replace(name, what, other);
    EXPECT_TRUE(says(read_depth_tables(copy.folder()).problem, "cannot be used")) << what;
  }
}

Scene block() {
  Scene scene =
      testing::box_scene(Mode::plane_strain, 0.1, {0, 0, 0}, {2, 1, 0}, testing::copper());
  testing::add_box(scene, "block", {0, 0, 0}, {1, 1, 0}, 2);
  scene.end_time = 1e-3;
  return scene;
}

TEST(PredictCost, IsUnknownWithoutTheNumbersAndSaysSo) {
  const Scene scene = block();
  const Probe probe = probe_cost(scene);
  CostTables none;
  none.problem = "they are gone";
  Prediction prediction = predict_cost(scene, probe, particle_counts(scene), 1, none);
  EXPECT_EQ(prediction.unknown, "they are gone");
  EXPECT_EQ(prediction.seconds, 0.0);
  EXPECT_EQ(prediction.steps, 0.0);
  EXPECT_GT(prediction.bytes, 0.0);

  CostTables other = cost_tables();
  other.updates.erase("update_stress Johnson-Cook");
  EXPECT_FALSE(update_cost(scene.materials[0].material(), other));
  prediction = predict_cost(scene, probe, particle_counts(scene), 1, other);
  EXPECT_TRUE(says(prediction.unknown, "no row \"update_stress Johnson-Cook\""));
  EXPECT_EQ(prediction.seconds, 0.0);
  EXPECT_GT(prediction.steps, 0.0);
  EXPECT_EQ(predict_cost(scene, probe, particle_counts(scene), 1).unknown, "");

  std::string lines;
  for (const std::string& line : result_numbers(scene, {}, {}, {}, prediction))
    lines += line + "\n";
  EXPECT_TRUE(says(lines, "predicted: unknown (the measured numbers")) << lines;
}

TEST(DepthDoubt, IsUnknownWithoutTheNumbersAndSaysSo) {
  DepthTables none;
  none.problem = "they are gone";
  Scene scene = block();
  scene.jet.present = true;
  scene.jet.direction = 1.0;
  scene.jet.launch_position = -0.2;
  scene.jet.slugs = {{0.0, 7000.0, 0.1, 0.1, 8930.0}};
  const DepthDoubt doubt = depth_doubt(scene, 1e-3, 0.0, none);
  EXPECT_EQ(doubt.unknown, "they are gone");
  EXPECT_EQ(
      depth_doubt_text(doubt), std::string("unknown (they are gone); ") + unknown_error_advice
  );
}

}  // namespace
}  // namespace barreno
