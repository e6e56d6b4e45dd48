// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/arenisca_points.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

namespace barreno {

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

/// Whoever reads the sum of results keeps the work from being left out.
inline void read_sum(double sum) {
  if (!std::isfinite(sum)) std::printf("not finite\n");
}

/// What updates cost, per point.
struct RockCost {
  double nanoseconds = 0.0;
  double substeps = 0.0;
};

/// Least time of several runs through all points, one after the other, by the model's update().
template <class Model, class Point>
RockCost cost_of_single_points(const Model& model, const std::vector<Point>& points, int runs) {
  RockCost cost;
  double sum = 0.0;
  const auto per_point = 1.0 / static_cast<double>(points.size());
  cost.nanoseconds = per_point * min_time(runs, [&] {
                       cost.substeps = 0.0;
                       for (const Point& p : points) {
                         auto stress = p.stress;
                         auto history = p.history;
                         cost.substeps += model.update(p.increment, stress, history).substeps;
                         sum += stress.xx;
                       }
                     });
  cost.substeps *= per_point;
  read_sum(sum);
  return cost;
}

#if BARRENO_HAS_LANES
/// The same in lanes, as in the stress update of a run: groups that flow wait for others [ns].
template <class Model>
double cost_in_lanes(
    const Model& model, const std::vector<test::PointOf<Model>>& points, int runs
) {
  using Points = typename Model::template Points<Lanes>;
  double sum = 0.0;
  std::vector<Points> groups;
  for (std::size_t first = 0; first + lane_count <= points.size(); first += lane_count) {
    std::array<std::size_t, lane_count> of{};
    for (std::size_t i = 0; i < of.size(); ++i) of[i] = first + i;
    groups.push_back(test::gather(points, of.data()));
  }
  std::array<Points, Model::groups_together> waiting;
  std::array<LaneMask, Model::groups_together> rest;
  const double total = min_time(runs, [&] {
    std::size_t count = 0;
    const auto finish = [&] {
      model.finish_points(waiting.data(), rest.data(), static_cast<int>(count));
      for (std::size_t g = 0; g < count; ++g) sum += waiting[g].stress.xx[0];
      count = 0;
    };
    for (const Points& group : groups) {
      Points p = group;
      const LaneMask flows = model.start_points(p);
      sum += p.stress.xx[0];
      if (!real::any(flows)) continue;
      waiting[count] = p;
      rest[count] = flows;
      if (++count == waiting.size()) finish();
    }
    if (count > 0) finish();
  });
  read_sum(sum);
  return total / static_cast<double>(groups.size() * lane_count);
}
#else
template <class Model>
double cost_in_lanes(
    const Model& model, const std::vector<test::PointOf<Model>>& points, int runs
) {
  return cost_of_single_points(model, points, runs).nanoseconds;
}
#endif

/// Prints what Arenisca's update costs per point, by single points and in lanes: for points that
/// stay elastic, and for points that flow, drawn like those of a penetration run.
void print_cost_of_rock();

}  // namespace barreno
