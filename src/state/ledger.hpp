// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/reproducible_sum.hpp"

#include <array>
#include <vector>

namespace barreno {

/// Why a particle was taken out of the run or held.
enum class RemovalCause { left_grid, not_finite, material_failure, expanded, inverted };
inline constexpr int removal_causes = 5;
inline constexpr std::array<const char*, removal_causes> removal_names{
    "left_grid", "not_finite", "material_failure", "expanded", "inverted"};

template <class Number>
struct RemovalTallyOf {
  Number count{};
  Number mass{}, momentum{}, kinetic{};  ///< axial momentum (y)
};
using RemovalTally = RemovalTallyOf<double>;

/// Mass, axial momentum and energy of the run, each term measured where it arises and none found by
/// difference. Sums since t = 0 unless said otherwise.
///
///   kinetic + elastic + plastic + viscous + friction + damped + removed
///     = initial_kinetic + launched + prestress + explosive + boundary_work + body_work +
///     fluid_work
///     + transfer + stress_integration + remainder
///
/// `elastic` keeps what later removed particles had stored; `removed` is their kinetic energy.
template <class Number>
struct LedgerTerms {
  Number mass{}, momentum{}, kinetic{};  ///< of the particles now
  Number initial_mass{}, initial_momentum{}, initial_kinetic{};
  Number launched_mass{}, launched_momentum{}, launched_kinetic{};
  /// What APIC's particles remember of the grid's kinetic energy now, beside `kinetic`.
  Number remembered{};
  Number prestress{};           ///< elastic energy of the initial equilibrium
  Number elastic{};             ///< prestress plus recoverable work since then
  Number plastic{};             ///< dissipated work of the materials
  Number viscous{};             ///< work of the artificial viscosity
  Number explosive{};           ///< sum V_ref (E0 - E) of explosives, in no other term
  Number friction{};            ///< dissipated by surfaces that slide on each other
  Number boundary_work{};       ///< of loads, moving conditions and rigid bodies on the material
  Number fluid_work{};          ///< that pore fluid brings into the rock where it flows in
  Number body_work{};           ///< of the body force
  Number damped{};              ///< work done against the damping of the step
  Number stress_integration{};  ///< work of internal nodal forces plus trapezoidal stress work of
                                ///< the particles
  Number transfer{};  ///< kinetic energy gained between particles and grid (contact included: < 0)
  Number condition_impulse{};  ///< axial impulse of the conditions on the material
  Number load_impulse{};       ///< axial impulse of the loads
  Number body_impulse{};       ///< axial impulse of the body force
  Number damping_impulse{};    ///< axial impulse of the damping
  Number rigid_impulse{};      ///< axial impulse of rigid bodies on the material
  std::array<RemovalTallyOf<Number>, removal_causes> removed{};
  Number held{};      ///< particles that became stress-free debris
  Number unloaded{};  ///< particles whose loaded faces were torn off
  Number clipped{};   ///< particles whose domain is cut at Largest Domain, now
};

/// What of the ledger's terms of these names belongs to one material; the sums over the materials
/// are those terms. A run that continues another has no prestress here: no particle keeps it.
template <class Number>
struct MaterialEnergiesOf {
  Number prestress{}, elastic{}, plastic{}, viscous{}, explosive{};
};
using MaterialEnergies = MaterialEnergiesOf<double>;
using OwnMaterialEnergies = MaterialEnergiesOf<ReproducibleSum>;

/// Of all ranks.
struct Ledger : LedgerTerms<double> {
  double retried_steps = 0.0;
  std::vector<MaterialEnergies> materials;  ///< in the order of Scene::materials
};

/// This rank's part: whole sums, so that the ledger of all ranks does not depend on who has which
/// particles.
struct OwnLedger : LedgerTerms<ReproducibleSum> {
  double retried_steps = 0.0;  ///< the same on every rank
  std::vector<OwnMaterialEnergies> materials;
};

/// ReproducibleSum::carry() of all terms.
void carry(OwnLedger& ledger);

}  // namespace barreno
