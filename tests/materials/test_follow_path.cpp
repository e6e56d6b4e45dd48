// SPDX-License-Identifier: BSD-3-Clause
/// Points that are taken along paths of given strains and stresses: closed forms of elasticity, the
/// point that the update itself leads to by the strains that were taken, points that fail, and
/// calls that are refused.

#include <gtest/gtest.h>

#include <algorithm>
#include <barreno_material.h>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace barreno::test {
namespace {

constexpr double free_strain = std::numeric_limits<double>::quiet_NaN();  // NaN: strain is given
constexpr double bulk = 40e9, shear = 30e9;                               // of the glass [Pa]
constexpr int components = 6;

struct CardOfPath {
  explicit CardOfPath(const std::string& card) : m(barreno_material_open(card.c_str())) {}
  ~CardOfPath() { barreno_material_close(m); }
  CardOfPath(const CardOfPath&) = delete;
  CardOfPath& operator=(const CardOfPath&) = delete;
  barreno_material* m;
};

std::string shipped(const std::string& name) {
  return std::string(BARRENO_SOURCE_DIR) + "/materials/cards/" + name + ".xml";
}
std::string glass() {
  std::string file = ::testing::TempDir() + "follow_path_glass.xml";
  std::ofstream(file) << R"(<ParameterList name="Glass">
  <Parameter name="Model" type="string" value="Linear Elastic"/>
  <Parameter name="Density" type="double" value="2500"/>
  <Parameter name="Bulk Modulus" type="string" value="40 GPa"/>
  <Parameter name="Shear Modulus" type="string" value="30 GPa"/>
</ParameterList>
)";
  return file;
}

/// Arrays of a path; nothing is held before `hold`.
struct PathArrays {
  int count, steps, states;
  std::vector<double> strain, wanted, stress_old, state_old, taken, stress, state_new;
  std::vector<int> status;

  PathArrays(const barreno_material* m, int points, int length)
      : count(points), steps(length), states(barreno_material_state_count(m)) {
    const auto points_n = static_cast<std::size_t>(count);
    const std::size_t all = points_n * static_cast<std::size_t>(steps) * components;
    strain.assign(all, 0.0);
    wanted.assign(all, free_strain);
    taken.assign(all, -1.0);
    stress.assign(all, -1.0);
    stress_old.assign(points_n * components, 0.0);
    state_new.assign(points_n * static_cast<std::size_t>(states), -1.0);
    status.assign(points_n, -1);
    for (int i = 0; i < count; ++i)
      for (int s = 0; s < states; ++s) state_old.push_back(barreno_material_state_initial(m, s));
  }
  std::size_t at(int step, int point, int component) const {
    const int row = step * count + point;
    return static_cast<std::size_t>(row) * components + static_cast<std::size_t>(component);
  }
  barreno_path path(double dt) {
    return {
        count,
        steps,
        dt,
        strain.data(),
        wanted.data(),
        stress_old.data(),
        state_old.data(),
        taken.data(),
        stress.data(),
        state_new.data(),
        status.data()};
  }
  int follow(const barreno_material* m, double dt = 1.0) {
    const barreno_path all = path(dt);
    return barreno_material_follow(m, &all);
  }
};

/// The largest difference between a path's stresses and those of the update by the strains taken,
/// step by step; its states must be the same bits.
double difference_to_updates(const barreno_material* m, const PathArrays& a, double dt) {
  std::vector<double> stress = a.stress_old, state = a.state_old;
  double largest = 0.0;
  for (int k = 0; k < a.steps; ++k) {
    std::vector<double> stress_new(stress.size()), state_new(state.size());
    std::vector<int> status(static_cast<std::size_t>(a.count));
    barreno_batch batch{};
    batch.count = a.count;
    batch.want = BARRENO_STRESS;
    batch.time_increment = dt;
    batch.strain_increment = &a.taken[a.at(k, 0, 0)];
    batch.stress_old = stress.data();
    batch.stress_new = stress_new.data();
    batch.state_old = state.data();
    batch.state_new = state_new.data();
    batch.status = status.data();
    EXPECT_EQ(barreno_material_update(m, &batch), 0) << barreno_last_error();
    stress = stress_new;
    state = state_new;
    for (std::size_t i = 0; i < stress.size(); ++i)
      largest = std::max(largest, std::fabs(stress[i] - a.stress[a.at(k, 0, 0) + i]));
  }
  EXPECT_EQ(state, a.state_new);
  return largest;
}

TEST(FollowPath, FindsTheClosedFormsOfElasticity) {
  const CardOfPath card(glass());
  ASSERT_NE(card.m, nullptr) << barreno_last_error();
  PathArrays a(card.m, 3, 2);
  for (int k = 0; k < 2; ++k) {
    a.strain[a.at(k, 0, 0)] = -1e-4;  // uniaxial stress along 11
    for (const int held : {1, 2}) a.wanted[a.at(k, 0, held)] = 0.0;
    a.wanted[a.at(k, 1, 4)] = 3e6 * (k + 1);                                           // shear 13
    for (int held = 0; held < 3; ++held) a.wanted[a.at(k, 2, held)] = -4e6 * (k + 1);  // pressure
  }
  ASSERT_EQ(a.follow(card.m), 0) << barreno_last_error();
  const double young = 9.0 * bulk * shear / (3.0 * bulk + shear);
  const double poisson = 0.5 * (3.0 * bulk - 2.0 * shear) / (3.0 * bulk + shear);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(a.stress[a.at(k, 0, 0)], -1e-4 * young * (k + 1), 1e-6 * 1e-4 * young);
    EXPECT_EQ(a.taken[a.at(k, 0, 0)], -1e-4) << "given strains are taken as they are";
    for (const int held : {1, 2})
      EXPECT_NEAR(a.taken[a.at(k, 0, held)], 1e-4 * poisson, 1e-6 * 1e-4);
    EXPECT_NEAR(a.taken[a.at(k, 1, 4)], 0.5 * 3e6 / shear, 1e-6 * 3e6 / shear)
        << "shear strains are those of the tensor";
    EXPECT_NEAR(a.taken[a.at(k, 2, 0)], -4e6 / (3.0 * bulk), 1e-6 * 4e6 / bulk);
  }
}

TEST(FollowPath, LetsHeldComponentsChangeFromStepToStep) {
  const CardOfPath card(glass());
  ASSERT_NE(card.m, nullptr) << barreno_last_error();
  PathArrays a(card.m, 1, 3);
  a.strain[a.at(0, 0, 0)] = -2e-4;  // no strain across
  a.wanted[a.at(1, 0, 1)] = 0.0;    // one side let go
  a.wanted[a.at(2, 0, 0)] = 0.0;    // unloaded
  a.wanted[a.at(2, 0, 1)] = a.wanted[a.at(2, 0, 2)] = 0.0;
  ASSERT_EQ(a.follow(card.m), 0) << barreno_last_error();
  EXPECT_NEAR(a.stress[a.at(0, 0, 1)], -2e-4 * (bulk - 2.0 / 3.0 * shear), 1.0);
  EXPECT_NEAR(a.stress[a.at(1, 0, 1)], 0.0, 1e-6 * 1e7);
  for (int c = 0; c < components; ++c) {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) sum += a.taken[a.at(k, 0, c)];
    EXPECT_NEAR(sum, 0.0, 1e-9) << "an elastic point that bears nothing has its first shape";
  }
}

/// Metal far beyond yield and rock that is sheared under pressure: held stresses are met, and the
/// update by the strains that were taken leads to the same point.
TEST(FollowPath, MeetsHeldStressesOfPointsThatFlow) {
  constexpr double dt = 1e-3;
  constexpr int steps = 30;
  for (const char* name : {"copper", "steel_4340", "berea_sandstone"}) {
    SCOPED_TRACE(name);
    const CardOfPath card(shipped(name));
    ASSERT_NE(card.m, nullptr) << barreno_last_error();
    PathArrays a(card.m, 2, steps);
    for (int k = 0; k < steps; ++k)
      for (int point = 0; point < 2; ++point) {
        a.strain[a.at(k, point, 0)] = -1e-3;
        for (const int held : {1, 2})
          a.wanted[a.at(k, point, held)] = -20e6 * (point + 1) * std::min(1.0, (k + 1) / 5.0);
      }
    ASSERT_EQ(a.follow(card.m, dt), 0) << barreno_last_error();
    double size = 0.0, plastic = 0.0;
    for (const double s : a.stress) size = std::max(size, std::fabs(s));
    for (std::size_t i = 0; i < a.stress.size(); ++i)
      if (!std::isnan(a.wanted[i]))
        EXPECT_NEAR(a.stress[i], a.wanted[i], 1e-7 * size) << i;
      else
        EXPECT_EQ(a.taken[i], a.strain[i]) << i;
    EXPECT_EQ(difference_to_updates(card.m, a, dt), 0.0);
    for (int s = 0; s < a.states; ++s) {
      const std::string state = barreno_material_state_name(card.m, s);
      if (state == "plastic_strain" || state == "equivalent_plastic_strain")
        plastic = a.state_new[static_cast<std::size_t>(s)];
    }
    EXPECT_GT(plastic, 0.01);
  }
}

TEST(FollowPath, LeavesAPointThatFailsWhereItWas) {
  const CardOfPath card(shipped("berea_sandstone"));
  ASSERT_NE(card.m, nullptr) << barreno_last_error();
  PathArrays a(card.m, 2, 3);
  for (int k = 0; k < 3; ++k)
    for (int point = 0; point < 2; ++point) a.strain[a.at(k, point, 0)] = -1e-4;
  for (const int held : {1, 2}) a.wanted[a.at(1, 1, held)] = 1e9;  // no rock bears that tension
  EXPECT_EQ(a.follow(card.m), 1);
  EXPECT_EQ(a.status, (std::vector<int>{BARRENO_OK, BARRENO_NOT_CONVERGED}));
  for (int c = 0; c < components; ++c) {
    for (const int k : {1, 2}) {
      EXPECT_EQ(a.stress[a.at(k, 1, c)], a.stress[a.at(0, 1, c)]);
      EXPECT_EQ(a.taken[a.at(k, 1, c)], 0.0);
    }
    EXPECT_EQ(a.stress[a.at(0, 1, c)], a.stress[a.at(0, 0, c)]) << "neighbours do not meet";
  }
  EXPECT_LT(a.stress[a.at(2, 0, 0)], a.stress[a.at(0, 0, 0)]);
}

TEST(FollowPath, RefusesCallsAndWritesNothing) {
  const CardOfPath card(glass());
  ASSERT_NE(card.m, nullptr) << barreno_last_error();
  const auto refused = [&](const auto& spoil, const char* why) {
    PathArrays a(card.m, 1, 1);
    barreno_path path = a.path(1.0);
    spoil(path);
    EXPECT_EQ(barreno_material_follow(card.m, &path), -1) << why;
    EXPECT_NE(std::string(barreno_last_error()).find(why), std::string::npos)
        << barreno_last_error();
    EXPECT_EQ(a.stress, std::vector<double>(components, -1.0));
    EXPECT_EQ(a.taken, std::vector<double>(components, -1.0));
  };
  refused([](barreno_path& path) { path.stress_wanted = nullptr; }, "NULL");
  refused([](barreno_path& path) { path.state_new = nullptr; }, "NULL");
  refused([](barreno_path& path) { path.count = -1; }, "-1 points");
  refused([](barreno_path& path) { path.steps = -1; }, "-1 steps");
  PathArrays a(card.m, 1, 1);
  EXPECT_EQ(a.follow(nullptr), -1);
  EXPECT_EQ(barreno_material_follow(card.m, nullptr), -1);
  EXPECT_EQ(a.follow(card.m, -1.0), 1) << "time that goes back fails the point";
  EXPECT_EQ(a.status[0], BARRENO_NOT_CONVERGED);
  EXPECT_EQ(a.stress, a.stress_old);
  EXPECT_EQ(a.taken, std::vector<double>(components, 0.0));
}

}  // namespace
}  // namespace barreno::test
