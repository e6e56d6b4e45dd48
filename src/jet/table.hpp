// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"
#include "deck/sections/jet_monitor_section.hpp"
#include "deck/sections/jet_section.hpp"

#include <string>
#include <vector>

namespace barreno {

/// A particle where it crosses the plane of a Jet Monitor.
struct JetCrossing {
  ParticleId id = 0;
  double time = 0.0;    ///< [time]
  double mass = 0.0;    ///< [mass]
  double speed = 0.0;   ///< along the direction of flight [length/time]
  double square = 0.0;  ///< of the whole velocity [length^2/time^2]
  double radius = 0.0;  ///< from the axis [length]
};

/// Mass, momentum and kinetic energy along the direction of flight.
struct JetSums {
  double count = 0.0, mass = 0.0, momentum = 0.0, kinetic = 0.0;
};

/// What crossed, and what the table says of it.
struct JetAudit {
  JetSums crossed;                ///< particles of the jet
  JetSums table;                  ///< slugs
  JetSums slow, wide;             ///< crossings that are not of the jet
  double lateral = 0.0;           ///< kinetic energy of motion across the direction of flight
  double slice_loss = 0.0;        ///< of the kinetic energy, by one velocity per slug [-]
  double mass_beyond = 0.0;       ///< of the monitored bodies, ahead of the plane at the end
  double largest_void = 0.0;      ///< 1 - density / material's, of the emptiest slug [-]
  double largest_particle = 0.0;  ///< share of the crossed mass, of the heaviest particle [-]
};

/// Slugs of a table, from what crossed in each interval dt: velocity u = sum m v / sum m, length
/// u dt, so that slugs of neighbouring intervals touch; solid radius r_s with
/// sum m = rho_0 pi r_s^2 u dt; radius r_o = R / sqrt(0.95), R that of 95 % of the mass, at least
/// r_s; density rho_0 (r_s / r_o)^2. Mass and momentum are those of the particles, the kinetic
/// energy less by their spread within a slug (`slice_loss`).
/// @param crossings  in order of time and id, so that sums do not depend on the ranks
std::vector<JetSlug> jet_slugs(
    const JetMonitorSpec& monitor, const std::vector<JetCrossing>& crossings
);

JetAudit audit_jet(
    const JetMonitorSpec& monitor,
    const std::vector<JetCrossing>& crossings,
    const std::vector<JetSlug>& slugs
);

/// The file that Jet/Table reads.
std::string jet_table_text(const JetMonitorSpec& monitor, const std::vector<JetSlug>& slugs);

}  // namespace barreno
