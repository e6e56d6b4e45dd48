// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

/// Prints what an update of a flowing Johnson-Cook point costs in lanes, with all points in the
/// first cache: what remains of update_stress is reading, writing and summing up.
void print_cost_of_metal();

}  // namespace barreno
