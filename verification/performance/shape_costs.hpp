// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

/// Nanoseconds per particle-step (fastest of five blocks of `steps`), those of the two kernels that
/// read and write the nodes, and bytes per particle, of every shape function in every mode.
void print_cost_of_shapes(int steps, double triad);

}  // namespace barreno
