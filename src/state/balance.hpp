// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"
#include "scene/scene.hpp"
#include "state/ledger.hpp"

#include <vector>

namespace barreno {

/// The ledger of the whole run on every rank, by one reduction: the same bits on any ranks.
Ledger sum_over_ranks(const Comm& comm, const OwnLedger& mine);

/// Its terms one after the other, as a checkpoint keeps them.
std::vector<ReproducibleSum> terms_of(const OwnLedger& ledger);
void put_terms(const std::vector<ReproducibleSum>& terms, OwnLedger& ledger);
/// Energies of its materials, likewise; as many materials as the ledger has.
std::vector<ReproducibleSum> material_terms_of(const OwnLedger& ledger);
void put_material_terms(const std::vector<ReproducibleSum>& terms, OwnLedger& ledger);

/// All causes together.
RemovalTally total_removed(const Ledger& ledger);

/// What a balance leaves over, and the same relative to what was put in, or to what numerical
/// errors moved if that is more: a rigid body may strain its neighbours in a step that does no work
/// yet.
struct Balance {
  double remainder = 0.0;
  double put_in = 0.0;
  double moved = 0.0;
  double error() const;  ///< infinite where something came from nothing
};

/// mass + removed - initial - launched, relative to initial + launched.
Balance mass_balance(const Ledger& ledger);

/// Axial momentum + removed - initial - launched - impulses of conditions, loads, body force and
/// damping, relative to sqrt(2 m E) of what moved at the start, of the jet and of the work of loads
/// and body force, plus the magnitudes of the impulses; where numerical errors moved more energy
/// than was put in, at least to sqrt(2 m E) of the difference. Where nothing was put in or moved, a
/// momentum whose kinetic energy is below the resolution of its sum counts as zero.
Balance momentum_balance(const Ledger& ledger);

/// The remainder of the identity at `Ledger`, relative to initial_kinetic + launched + prestress +
/// |explosive| + |boundary_work| + |body_work|, or to the largest of |fluid_work|, |transfer| and
/// |stress_integration|.
Balance energy_balance(const Ledger& ledger);

/// What the method itself has added to the energy (< 0: taken from it), relative to the scale of
/// energy_balance. Its remainder does not show these errors: the ledger names them.
struct NumericalEnergy {
  double stress_integration = 0.0, transfer = 0.0;
  double sum() const { return stress_integration + transfer; }
};
NumericalEnergy numerical_energy(const Ledger& ledger);

/// Mass, axial momentum and kinetic energy of the jet's first `slugs` slugs as the table gives
/// them, of the part that lies within the grid: the full circle in axisymmetry, per unit thickness
/// in plane strain, of the part inside in three dimensions.
struct JetTotals {
  double mass = 0.0, momentum = 0.0, kinetic = 0.0;
};
JetTotals jet_table_totals(const Scene& scene, std::size_t slugs);

/// Mass of every slug of the table, likewise.
std::vector<double> jet_table_masses(const Scene& scene);

}  // namespace barreno
