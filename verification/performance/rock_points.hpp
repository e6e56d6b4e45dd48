// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/arenisca_points.hpp"

#include <vector>

namespace barreno {

/// What updates cost, per point.
struct RockCost {
  double nanoseconds = 0.0;
  double substeps = 0.0;
};

/// Least time of several runs through all points, one after the other.
RockCost cost_of_single_points(
    const Arenisca& model, const std::vector<test::RockPoint>& points, int runs
);

/// The same in lanes, as in the stress update of a run: groups that flow wait for others [ns]. The
/// number of points is a multiple of the lanes.
double cost_in_lanes(const Arenisca& model, const std::vector<test::RockPoint>& points, int runs);

/// Prints what Arenisca's update costs per point, by single points and in lanes: for points that
/// stay elastic, and for points that flow, drawn like those of a penetration run.
void print_cost_of_rock();

}  // namespace barreno
