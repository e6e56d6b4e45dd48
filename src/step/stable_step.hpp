// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"
#include "step/order/locate_particles.hpp"

namespace barreno {

// The step that one particle allows is StableStepRule::stable_step (stable_step_rule.hpp).
// update_stress finds the least of its rows, find_dormant_tiles that of tiles at rest.

/// Smallest step that the particles now in the state allow, from their modulus and speed: for
/// particles that had no stress update yet (start of a run, launched jet) [time].
double stable_step_of_rows(
    const StepSpec& spec, const Grid& grid, const Particles& particles, int first_row
);

/// Smallest step that the cells of a set allow whose rows decide by cells (cell_step.hpp) [time].
/// @pre  the rows are sorted by cell
double stable_step_of_cells(const StepSpec& spec, const Grid& grid, const Particles& particles);

/// The fraction f of the step that is stable with damping a, where `dt` is the fraction of the one
/// without, 2 / omega:
///
///   dt = 4 f / (a + sqrt(a^2 + 4 omega^2))
///
/// With v' = (1 - a dt) v - omega^2 dt x and x' = x + dt v' that is where an eigenvalue reaches -1
/// (tests/unit/step/test_stable_step.cpp); much damping leaves 2 f / a [time].
double damped_step(double dt, double damping, double fraction);

/// The least stable step of all ranks, and what else they must agree on: one reduction.
///
/// @param stable_step        of this rank [time]
/// @param[in,out] placement  in: this rank's; out: of any rank
double agree_on_stable_step(
    const Teuchos::Comm<int>& comm, double stable_step, Placement& placement
);
/// The same, and the set that has it.
///
/// @param agreed    room for what is sent
/// @param[out] set  -1: none, but tiles at rest
double agree_on_stable_step(
    const Teuchos::Comm<int>& comm,
    const std::vector<Particles>& sets,
    double stable_step,
    std::vector<double>& agreed,
    Placement& placement,
    int& set
);

/// What of next_step's rule sets the step.
enum class StepRule { stable, growth, largest, event };
struct NextStep {
  double dt;  ///< [time]
  StepRule set_by;
};

/// The size of the next step.
///
///   dt = min(stable step, growth limit * last dt, largest step, time to the next event)
///
/// @param next_time    the step ends there at the latest, exactly [time]
/// @param stable_step  of all ranks, without damping
NextStep next_step(const StepSpec& spec, const Clock& clock, double next_time, double stable_step);

}  // namespace barreno
