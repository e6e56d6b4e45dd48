// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

/// Time of a material's update, per particle-step.
struct UpdateCost {
  const char* verb;         ///< or what check/update_row.hpp makes of it
  double elastic, running;  ///< ns in the first steps, and on average over a run
  bool is_early = false;    ///< the run ended early: in a longer one more rock flows
};

/// Printed by `verification/predictions.py BARRENO`, which runs a deck for each row that flows;
/// rows of rated, angled and general forms are processor times, the least of five short runs for
/// the first steps. Only the ratio is used: what a nanosecond of that machine is here, the probe of
/// each run measures. Beside other work the first steps wait longer for memory, which flow does not
/// need: dry rock of a perforation takes 2.8 to 3.0 times as long as at first there, 3.65 times on
/// a machine of its own. The row is between them, other forms are in proportion to dry rock of the
/// same deck. The forms for comparison ran to 12 us (elastic centre) and to 4 us; arenisca3 has the
/// row of plastic. A metal with voids has the metal's update between them; updates of the last rows
/// do not depend on the state.
constexpr UpdateCost update_costs[] = {
    {"update_stress Arenisca", 63.0, 208.0},
    {"update_stress Arenisca wet", 82.0, 330.0},
    {"update_stress Arenisca scattered", 69.0, 228.0},
    {"update_stress Arenisca rated", 124.0, 260.0},
    {"update_stress Arenisca rated wet", 151.0, 362.0},
    {"update_stress Arenisca angled", 93.0, 344.0},
    {"update_stress Arenisca angled wet", 111.0, 503.0},
    {"update_stress Arenisca general, elastic centre", 1170.0, 2850.0},
    {"update_stress Arenisca general, plastic", 1240.0, 5240.0, true},
    {"update_stress Arenisca general, arenisca3", 1240.0, 5240.0, true},
    {"update_stress Arenisca general, bisection", 403.0, 12080.0, true},
    {"update_stress Johnson-Cook", 28.0, 52.0},
    {"update_stress Johnson-Cook expanded", 28.0, 52.0},
    {"update_stress JWL Explosive", 1.0, 1.0},
    {"update_stress Linear Elastic", 1.0, 1.0},
    {"update_stress Neo-Hookean", 1.0, 1.0},
    {"update_stress Poroelastic", 1.0, 1.0},
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
