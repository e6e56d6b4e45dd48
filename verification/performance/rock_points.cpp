// SPDX-License-Identifier: BSD-3-Clause
#include "rock_points.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <vector>

namespace barreno {
namespace {

using test::RockPoint;

/// Least time of several runs [ns].
template <class Run>
double min_time(int runs, const Run& run) {
  double least = HUGE_VAL;
  for (int i = 0; i < runs; ++i) {
    const auto start = std::chrono::steady_clock::now();
    run();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    least = std::min(least, taken.count());
  }
  return least * 1e9;
}

}  // namespace

RockCost cost_of_single_points(
    const Arenisca& model, const std::vector<RockPoint>& points, int runs
) {
  RockCost cost;
  double checksum = 0.0;
  const auto per_point = 1.0 / static_cast<double>(points.size());
  cost.nanoseconds = per_point * min_time(runs, [&] {
                       cost.substeps = 0.0;
                       for (const RockPoint& p : points) {
                         Sym3 stress = p.stress;
                         Arenisca::History history = p.history;
                         cost.substeps += model.update(p.increment, stress, history).substeps;
                         checksum += stress.xx;
                       }
                     });
  cost.substeps *= per_point;
  // Whoever reads the sum keeps the work from being left out.
  if (!std::isfinite(checksum)) std::printf("not finite\n");
  return cost;
}

double cost_in_lanes(const Arenisca& model, const std::vector<RockPoint>& points, int runs) {
#if BARRENO_HAS_LANES
  double checksum = 0.0;
  std::vector<Arenisca::Points<Lanes>> groups;
  for (std::size_t first = 0; first < points.size(); first += lane_count) {
    std::array<std::size_t, lane_count> of{};
    for (std::size_t i = 0; i < of.size(); ++i) of[i] = first + i;
    const test::RockLanes g = test::gather(points, of.data());
    groups.push_back(Arenisca::Points<Lanes>{g.increment, g.stress, g.history, {}});
  }
  // As in the stress update: groups that flow wait for others.
  std::array<Arenisca::Points<Lanes>, Arenisca::groups_together> waiting;
  std::array<LaneMask, Arenisca::groups_together> rest;
  const double total = min_time(runs, [&] {
    std::size_t count = 0;
    const auto finish = [&] {
      model.finish_points(waiting.data(), rest.data(), static_cast<int>(count));
      for (std::size_t g = 0; g < count; ++g) checksum += waiting[g].stress.xx[0];
      count = 0;
    };
    for (const auto& group : groups) {
      Arenisca::Points<Lanes> p = group;
      const LaneMask flows = model.start_points(p);
      checksum += p.stress.xx[0];
      if (!real::any(flows)) continue;
      waiting[count] = p;
      rest[count] = flows;
      if (++count == waiting.size()) finish();
    }
    if (count > 0) finish();
  });
  if (!std::isfinite(checksum)) std::printf("not finite\n");
  return total / static_cast<double>(points.size());
#else
  return cost_of_single_points(model, points, runs).nanoseconds;
#endif
}

void print_cost_of_rock() {
  constexpr std::size_t point_count = 4096;
  constexpr int runs = 25;
  const Arenisca model(test::berea(), 2120.0);
  test::RockSampler sampler(model, 1);
  std::vector<RockPoint> elastic, plastic;
  while (elastic.size() < point_count || plastic.size() < point_count) {
    const RockPoint p = elastic.size() < point_count ? sampler.elastic() : sampler.flowing();
    RockPoint end = p;
    const bool flows = model.update(p.increment, end.stress, end.history).plastic_work > 0.0;
    auto& kind = flows ? plastic : elastic;
    if (kind.size() < point_count) kind.push_back(p);
  }
  const RockCost e = cost_of_single_points(model, elastic, runs);
  const RockCost p = cost_of_single_points(model, plastic, runs);
  std::printf("Arenisca, recorded-like states: ns per point, single points and lanes\n");
  std::printf(
      "  elastic point                %8.1f %8.1f\n",
      e.nanoseconds,
      cost_in_lanes(model, elastic, runs)
  );
  std::printf(
      "  plastic update               %8.1f %8.1f  (%.2f substeps)\n",
      p.nanoseconds,
      cost_in_lanes(model, plastic, runs),
      p.substeps
  );
}

}  // namespace barreno
