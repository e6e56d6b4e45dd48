// SPDX-License-Identifier: BSD-3-Clause
/// One rock, one increment, every entrance: what a run computes in lanes, the C interface, UMAT and
/// drive give the same bits of stress and history.
#include "barreno/models.hpp"
#include "barreno_material.h"
#include "drive/drive_point.hpp"
#include "drive/matrix.hpp"
#include "materials/general_card.hpp"

#include <gtest/gtest.h>

#include <barreno/history_values.hpp>
#include <barreno/registry.hpp>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#if BARRENO_HAS_LANES

// materials/hosts/umat.cpp
extern "C" void UMAT(  // NOLINT(readability-identifier-naming)
    double* stress,
    double* statev,
    double* ddsdde,
    double* sse,
    double* spd,
    double* scd,
    double* rpl,
    double* ddsddt,
    double* drplde,
    double* drpldt,
    const double* stran,
    const double* dstran,
    const double* time,
    const double* dtime,
    const double* temp,
    const double* dtemp,
    const double* predef,
    const double* dpred,
    const char* cmname,
    const int* ndi,
    const int* nshr,
    const int* ntens,
    const int* nstatv,
    const double* props,
    const int* nprops,
    const double* coords,
    const double* drot,
    double* pnewdt,
    const double* celent,
    const double* dfgrd0,
    const double* dfgrd1,
    const int* noel,
    const int* npt,
    const int* layer,
    const int* kspt,
    const int* kstep,
    const int* kinc
);

namespace barreno::test {
namespace {

constexpr double interval = 1e-8;

/// What a step asks of a point.
struct Asked {
  Sym3 strain;
  double dt;
};

/// A point as files list it: stress xx yy zz xy yz zx, and the history of its form.
struct Seen {
  double stress[6];
  std::vector<double> history;
};
void expect_same(const Seen& a, const Seen& b, const char* entrance, std::size_t which) {
  for (int i = 0; i < 6; ++i) EXPECT_EQ(a.stress[i], b.stress[i]) << entrance << ' ' << which;
  EXPECT_EQ(a.history, b.history) << entrance << ' ' << which;
}
template <class Form>
Seen seen(const Sym3& s, const typename Form::History& h) {
  const double* values = history_values<Form>(h);
  return {
      {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx},
      std::vector<double>(values, values + Form::history_count)};
}
Sym3 tensor(const double* s) {
  return {s[0], s[1], s[2], s[3], s[4], s[5]};
}

/// As update_stress of a run does it: in lanes, in two parts, in a lane of its own.
template <class Form>
Seen by_run(const Form& form, const Seen& begin, const Asked& asked) {
  constexpr int lane = lane_count - 1;
  typename Form::template Points<Lanes> p{};
  typename Form::History h;
  for (int i = 0; i < Form::history_count; ++i)
    reals_of<double>(h)[i] = begin.history[static_cast<std::size_t>(i)];
  const typename Form::History virgin = form.initial_history();
  for (int i = 0; i < lane_count; ++i) {
    set_lane(i == lane ? h : virgin, i, p.history);
    set_lane(i == lane ? tensor(begin.stress) : Sym3{}, i, p.stress);
    set_lane(i == lane ? asked.strain : Sym3{}, i, p.increment.strain);
  }
  p.increment.dt = Lanes{} + asked.dt;
  p.increment.volume_ratio_begin = p.increment.volume_ratio_end = Lanes{} + 1.0;
  const LaneMask flows = form.start_points(p);
  form.finish_points(&p, &flows, 1);
  EXPECT_NE(p.outcome.sound[lane], 0);
  return seen<Form>(
      lane_of<Sym3>(p.stress, lane), lane_of<typename Form::History>(p.history, lane)
  );
}

/// Place of a component 11 22 33 12 13 23 in xx yy zz xy yz zx.
constexpr int place[6] = {0, 1, 2, 3, 5, 4};

std::vector<double> state_of(const Seen& begin) {
  std::vector<double> state{1.0, 1.0};  // initialized, volume_ratio
  state.insert(state.end(), begin.history.begin(), begin.history.end());
  return state;
}
Seen seen_by_host(const double* stress, const std::vector<double>& state) {
  Seen end{{}, std::vector<double>(state.begin() + 2, state.end())};
  for (int i = 0; i < 6; ++i) end.stress[place[i]] = stress[i];
  return end;
}

Seen by_c_interface(const std::string& card, const Seen& begin, const Asked& asked) {
  barreno_material* material = barreno_material_open(card.c_str());
  const Sym3& strain = asked.strain;
  const double de[6] = {strain.xx, strain.yy, strain.zz, strain.xy, strain.zx, strain.yz};
  double old_stress[6], stress[6];
  for (int i = 0; i < 6; ++i) old_stress[i] = begin.stress[place[i]];
  std::vector<double> state = state_of(begin);
  barreno_batch batch{};
  batch.count = 1;
  batch.want = BARRENO_STRESS;
  batch.time_increment = asked.dt;
  batch.strain_increment = de;
  batch.stress_old = old_stress;
  batch.stress_new = stress;
  batch.state_old = state.data();
  batch.state_new = state.data();
  EXPECT_EQ(barreno_material_update(material, &batch), 0) << barreno_last_error();
  barreno_material_close(material);
  return seen_by_host(stress, state);
}

Seen by_umat(const std::string& card, const Seen& begin, const Asked& asked) {
  setenv("BARRENO_CARD", card.c_str(), 1);  // cmname = null
  const Sym3& strain = asked.strain;
  double engineering[6] = {
      strain.xx, strain.yy, strain.zz, 2.0 * strain.xy, 2.0 * strain.zx, 2.0 * strain.yz};
  double stress[6], ddsdde[36], pnewdt = 1.0;
  for (int i = 0; i < 6; ++i) stress[i] = begin.stress[place[i]];
  std::vector<double> state = state_of(begin);
  const int three = 3, six = 6, none = 0, states = static_cast<int>(state.size());
  UMAT(
      stress,
      state.data(),
      ddsdde,
      nullptr,
      nullptr,
      nullptr,
      nullptr,
      nullptr,
      nullptr,
      nullptr,
      nullptr,
      engineering,
      nullptr,
      &asked.dt,
      nullptr,
      nullptr,
      nullptr,
      nullptr,
      nullptr,
      &three,
      &three,
      &six,
      &states,
      nullptr,
      &none,
      nullptr,
      nullptr,
      &pnewdt,
      nullptr,
      nullptr,
      nullptr,
      nullptr,
      nullptr,
      nullptr,
      nullptr,
      nullptr,
      nullptr
  );
  EXPECT_EQ(pnewdt, 1.0) << barreno_last_error();
  return seen_by_host(stress, state);
}

/// A state of a run and the increment it was asked, of rock_points.csv.
struct Recorded {
  Seen begin;
  Asked asked;
};
std::vector<Recorded> recorded_points(std::size_t count) {
  std::ifstream file(BARRENO_SOURCE_DIR "/verification/performance/rock_points.csv");
  std::vector<Recorded> points;
  std::string line;
  while (points.size() < count && std::getline(file, line)) {
    if (line.rfind("flows,", 0) != 0) continue;
    std::istringstream row(line.substr(6));
    double v[10];
    char comma = ',';
    for (double& value : v) row >> value >> comma;
    points.push_back(
        {{{v[0], v[1], v[2], v[3], 0.0, 0.0}, {v[4], v[5]}},
         {{v[6], v[7], v[8], v[9], 0.0, 0.0}, interval}}
    );
  }
  return points;
}

TEST(Entrances, GiveTheBitsOfARunForItsIncrements) {
  const std::string card = berea_card_with("", "entrances_berea");
  const Material berea = read_card(card);
  const auto& form = std::get<Arenisca>(berea.model);
  const auto points = recorded_points(50);
  ASSERT_EQ(points.size(), 50U);
  int flow = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Seen& begin = points[i].begin;
    const Seen run = by_run(form, begin, points[i].asked);
    expect_same(by_c_interface(card, begin, points[i].asked), run, "C", i);
    expect_same(by_umat(card, begin, points[i].asked), run, "UMAT", i);
    flow += run.history[1] > begin.history[1] ? 1 : 0;
  }
  EXPECT_GT(flow, 40);
}

/// Every feature, from the virgin state into flow: drive too, which begins there.
TEST(Entrances, GiveTheSamePath) {
  const std::string card =
      berea_card_with(water_in_quartz + overstress + third_invariant, "entrances");
  const Material rock = read_card(card);
  const auto& form = std::get<AngledWetArenisca>(rock.model);
  using Form = AngledWetArenisca;
  std::vector<PathRow> path;
  for (int i = 0; i <= 20; ++i) {
    const double u = 1e-3 * i;
    const Mat3 f{{{1.0 - u, 0, 0}, {0, 1.0 + 0.3 * u, 0}, {0, 0, 1.0 - 0.2 * u}}};
    path.push_back({interval * i, f, i + 1});
  }
  const auto rows = drive_point(rock, path, {}, "path");
  const auto start = form.initial_state(0.0);
  Seen run = seen<Form>(start.stress, start.history);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Mat3& before = path[i - 1].deformation_gradient;
    const Mat3 g = *logarithm_1p((path[i].deformation_gradient - before) * inverse(before));
    const Asked asked{{g(0, 0), g(1, 1), g(2, 2), 0.0, 0.0, 0.0}, path[i].time - path[i - 1].time};
    const Seen c = by_c_interface(card, run, asked), umat = by_umat(card, run, asked);
    run = by_run(form, run, asked);
    expect_same(c, run, "C", i);
    expect_same(umat, run, "UMAT", i);
    const Sym3& s = rows[i].stress;
    const Seen driven{{s.xx, s.yy, s.zz, s.xy, s.yz, s.zx}, rows[i].history};
    expect_same(driven, run, "drive", i);
  }
  EXPECT_GT(run.history[1], 1e-3) << "it flows";
}

}  // namespace
}  // namespace barreno::test

#endif
