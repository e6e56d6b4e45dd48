// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"
#include "deck/sections/jet_kinds.hpp"

#include <barreno/input/schema.hpp>
#include <string>
#include <vector>

namespace barreno {

struct JetSlug {
  double time = 0.0;                  ///< its centre crosses the launch plane [time]
  double velocity = 0.0;              ///< [length/time]
  double radius = 0.0, length = 0.0;  ///< half-width instead of radius in plane strain [length]
  double density = 0.0;               ///< [mass/length^3]
  bool piece = false;  ///< it has broken off: it touches no other slug, whatever the jet's kind
};

struct JetSpec {
  bool present = false;
  int material = 0;  ///< index into Scene::materials
  std::string table_file;
  JetKind kind = JetKind::discrete;
  double pieces_below = 0.0;  ///< velocity below which slugs are pieces [length/time]
  /// The rows as the deck gives them, which the launched slugs are compared with; empty: `slugs`.
  std::vector<JetSlug> table;
  std::vector<JetSlug> slugs;     ///< as they are launched; launch times do not decrease
  double launch_position = 0.0;   ///< coordinate of the launch plane along y [length]
  double direction = 1.0;         ///< +1 or -1 along y
  int particles_per_cell = 4;     ///< per direction
  int splits = 0;                 ///< how often a particle wider than half a cell is divided in two
  double cells_per_radius = 0.0;  ///< wanted of its thinnest slug along its path; 0: as the grid is
};
template <>
const SectionTable<JetSpec>& table_of<JetSpec>();

/// Jet with its Profile.
input::Section jet_section();

}  // namespace barreno
