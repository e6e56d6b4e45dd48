// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pore_flow/porous_medium.hpp"

#include <string>

namespace barreno {

/// Lets pore fluid flow over the time since the last solve, when enough has passed; returns at once
/// in scenes without drained fluid. docs/method.md 7
///
/// @param dt  of the step that has just been made
/// @return why the fluid could not flow, one sentence, the same on every rank; empty: it could. If
/// the solver did not converge, everything is as before.
std::string drain_pore_fluid(
    const PorousMedium& medium, double dt, PoreFlowState& flow, OwnLedger& ledger
);

}  // namespace barreno
