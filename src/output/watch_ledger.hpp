// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output/progress.hpp"
#include "state/state.hpp"

namespace barreno {

/// A warning for each count of ledger_table() that has one, when it grows.
/// @param watched  what was warned about; becomes `ledger`
void watch_ledger(const Ledger& ledger, double time, Ledger& watched, Progress& progress);

}  // namespace barreno
