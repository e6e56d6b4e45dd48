// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/jet_state.hpp"
#include "state/ledger.hpp"

namespace barreno {

/// Make the particles of every slug whose launch time has come, each on the rank that owns its
/// place, and tally what was launched. A slug's centre is where it has flown since it crossed the
/// launch plane.
///
/// @param material           of the jet
/// @param time               of the step's start [time]
/// @param[in,out] launched   how far the jet has been launched
/// @param[in,out] particles  the set of the jet's material
/// @return the first row that is new; the particles are unplaced
int launch_jet(
    const JetSpec& jet,
    const MaterialSpec& material,
    const Grid& grid,
    double time,
    JetState& launched,
    Particles& particles,
    OwnLedger& ledger
);

}  // namespace barreno
