// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

/// Time of a material's update, per particle-step.
struct UpdateCost {
  const char* verb;
  double elastic, running;  ///< ns in the first steps, and on average over a run
};

/// Printed by `verification/predictions.py BARRENO`, which runs a deck for each row. Only the
/// ratio is used: what a nanosecond of that machine is here, the probe of each run measures. Rock
/// of perforations flows more than that of shells: the geometric mean of both, other forms in
/// proportion.
constexpr UpdateCost update_costs[] = {
    {"update_stress Arenisca", 63.0, 230.0},
    {"update_stress Arenisca wet", 82.0, 345.0},
    {"update_stress Arenisca scattered", 69.0, 236.0},
    {"update_stress Johnson-Cook", 28.0, 52.0},
};

/// Domains that deform reach more nodes than those of the first steps: perforation_plane_cpdi.xml.
constexpr double growth_of_domains = 1.6;

/// Rotations of three dimensions are found by iteration, from those of the step before:
/// taylor_bar_3d.xml.
constexpr double growth_of_rotations = 1.8;

/// What goes into nodes, cells and tiles in a part of a step (Step/Subcycles) for each awake
/// particle, over what nodes and cells take in the probe: 4.8 and 5.6 by the two pairs of runs of
/// docs/verification/subcycling.md.
constexpr double nodes_of_parts = 5.0;

/// Parts of a perforation's steps over those that the flight of its first slug would ask for to the
/// end: later slugs are slower. Without Subcycles single particles keep the step as short, or cells
/// as large as the jet's radius do. perforation.xml to 30 us: 0.77 (balanced), 0.68 (fast).
constexpr double parts_of_flight = 0.75;

/// Of a particle in an instant of particles.e, and in a row of history.csv [ns]:
/// spherical_wave.xml and colliding_disks.xml.
constexpr double field_nanoseconds = 350.0, row_nanoseconds = 12.0;

}  // namespace barreno
