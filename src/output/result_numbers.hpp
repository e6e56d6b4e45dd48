// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output/summary.hpp"

#include <string>
#include <vector>

namespace barreno {

/// What a run came to, as lines of its last block on the screen.
std::vector<std::string> result_numbers(
    const Scene& scene,
    const RunTotals& totals,
    const Penetration& penetration,
    const RunSummary& summary,
    const Prediction& prediction
);

}  // namespace barreno
