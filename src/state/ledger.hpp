// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace barreno {

/// Why a particle was taken out of the run or held.
enum class RemovalCause { left_grid, not_finite, material_failure, expanded, inverted };
inline constexpr int removal_causes = 5;
inline constexpr std::array<const char*, removal_causes> removal_names{
    "left_grid", "not_finite", "material_failure", "expanded", "inverted"};

struct RemovalTally {
  double count = 0.0;
  double mass = 0.0, momentum = 0.0, kinetic = 0.0;  ///< axial momentum (y)
};

/// Mass, axial momentum and energy of the run, each term measured where it arises and none found by
/// difference. Sums over this rank since t = 0 unless said otherwise; the writers add the ranks.
///
///   kinetic + elastic + plastic + viscous + friction + damped + removed
///     = initial_kinetic + launched + prestress + boundary_work + body_work + fluid_work + transfer
///     + stress_integration + remainder
///
/// `elastic` keeps what later removed particles had stored; `removed` is their kinetic energy.
struct Ledger {
  double mass = 0.0, momentum = 0.0, kinetic = 0.0;  ///< of the particles now
  double initial_mass = 0.0, initial_momentum = 0.0, initial_kinetic = 0.0;
  double launched_mass = 0.0, launched_momentum = 0.0, launched_kinetic = 0.0;
  /// What APIC's particles remember of the grid's kinetic energy now, beside `kinetic`.
  double remembered = 0.0;
  double prestress = 0.0;      ///< elastic energy of the initial equilibrium
  double elastic = 0.0;        ///< prestress plus recoverable work since then
  double plastic = 0.0;        ///< dissipated work of the materials
  double viscous = 0.0;        ///< work of the artificial viscosity
  double friction = 0.0;       ///< dissipated by surfaces that slide on each other
  double boundary_work = 0.0;  ///< of loads, moving conditions and rigid bodies on the material
  double fluid_work = 0.0;     ///< that pore fluid brings into the rock where it flows in
  double body_work = 0.0;      ///< of the body force
  double damped = 0.0;         ///< work done against the damping of the step
  double stress_integration =
      0.0;  ///< work of internal nodal forces plus trapezoidal stress work of the particles
  double transfer =
      0.0;  ///< kinetic energy gained between particles and grid (contact included: < 0)
  double condition_impulse = 0.0;  ///< axial impulse of the conditions on the material
  double load_impulse = 0.0;       ///< axial impulse of the loads
  double body_impulse = 0.0;       ///< axial impulse of the body force
  double damping_impulse = 0.0;    ///< axial impulse of the damping
  double rigid_impulse = 0.0;      ///< axial impulse of rigid bodies on the material
  std::array<RemovalTally, removal_causes> removed{};
  double held = 0.0;           ///< particles that became stress-free debris
  double unloaded = 0.0;       ///< particles whose loaded faces were torn off
  double clipped = 0.0;        ///< particles whose domain is cut at Largest Domain, now
  double retried_steps = 0.0;  ///< the same on every rank
};

}  // namespace barreno
