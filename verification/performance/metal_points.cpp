// SPDX-License-Identifier: BSD-3-Clause
#include "metal_points.hpp"

#include "support/scenes.hpp"

#include <algorithm>
#include <barreno/models.hpp>
#include <barreno/real.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <variant>
#include <vector>

namespace barreno {

#if BARRENO_HAS_LANES
namespace {

using Group = PointsOf<Sym3Of<Lanes>, JohnsonCook::HistoryOf<Lanes>>;

/// Strain increments of some 3e-4 in all directions of the plane, in steps of 0.1 us.
Group drawn_group(const JohnsonCook& model, std::mt19937_64& engine) {
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  Group group{};
  group.increment.dt = Lanes{} + 1e-7;
  group.increment.volume_ratio_begin = Lanes{} + 1.0;
  group.history.temperature = Lanes{} + model.initial_history().temperature;
  Sym3Of<Lanes>& strain = group.increment.strain;
  for (int i = 0; i < lane_count; ++i) {
    const double size = 3e-4 * std::exp(u(engine));
    strain.xx[i] = size * u(engine);
    strain.yy[i] = size * u(engine);
    strain.zz[i] = 0.3 * size * u(engine) - strain.xx[i] - strain.yy[i];
    strain.xy[i] = size * u(engine);
  }
  return group;
}

void update(const JohnsonCook& model, Group& group) {
  auto& increment = group.increment;
  increment.volume_ratio_end = increment.volume_ratio_begin + trace(increment.strain);
  group.outcome = model.update_points(increment, group.stress, group.history);
}

}  // namespace

void print_cost_of_metal() {
  constexpr int groups = 8, first_steps = 100, runs = 2000, rounds = 10;
  const MaterialSpec copper = testing::copper();
  const auto& model = std::get<JohnsonCook>(copper.material().model);
  std::mt19937_64 engine(1);
  std::vector<Group> start(groups);
  for (Group& group : start) group = drawn_group(model, engine);
  for (int step = 0; step < first_steps; ++step)
    for (Group& group : start) {
      update(model, group);
      group.increment.volume_ratio_begin = group.increment.volume_ratio_end;
    }
  double best = HUGE_VAL, work = 0.0;
  for (int run = 0; run < runs; ++run) {
    std::vector<Group> points = start;
    const auto begin = std::chrono::steady_clock::now();
    for (int round = 0; round < rounds; ++round)
      for (Group& group : points) update(model, group);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    best = std::min(best, taken.count() / (rounds * groups * lane_count));
    for (const Group& group : points) work += group.outcome.plastic_work[0];
  }
  std::printf(
      "Johnson-Cook, flowing, points alone in lanes: %.1f ns (%s)\n",
      1e9 * best,
      work > 0.0 ? "all in the first cache" : "none flows"
  );
}
#else
void print_cost_of_metal() {}
#endif

}  // namespace barreno
