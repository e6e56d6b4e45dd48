// SPDX-License-Identifier: BSD-3-Clause
#include "rock_points.hpp"

#include <cstdio>
#include <vector>

namespace barreno {

using test::RockPoint;

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
