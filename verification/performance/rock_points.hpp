// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

/// Prints what Arenisca's update costs per point, by single points and in lanes: for points that
/// stay elastic, and for points that flow, drawn like those of a penetration run.
void print_cost_of_rock();

}  // namespace barreno
