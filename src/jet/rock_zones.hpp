// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"
#include "state/state.hpp"

#include <cstddef>
#include <vector>

namespace barreno {

struct JetPath;
struct Penetration;

/// Porous rock around the open channel half-way down its length in one body: rings one cell wide
/// from the wall outwards and four cells high, with the porosity that crushing and dilation have
/// left, phi = 1 - (1 - phi_0) exp(-e), e the plastic volume strain, and the breakage of its
/// grains; elastic strain is left out.
///
/// A ring is crushed or dilated where its porosity is more than 5 % of phi_0 away from it, and
/// impaired where its permeability (jet/rock_permeability.hpp) is below 70 % of the virgin one. The
/// skin is Hawkins' sum of (k_0/k - 1) ln(r_outer/r_inner) (Trans. AIME 207 (1956) 356), with at
/// least 1e-4 of the virgin permeability. Without such a ring the radii are those of the wall.
struct RockZones {
  std::size_t body = 0;                         ///< index into Scene::bodies
  double depth = 0.0, wall = 0.0;               ///< of the rings, and their inner radius [length]
  double crushed_from = 0.0, crushed_to = 0.0;  ///< [length]
  double dilated_to = 0.0, impaired_to = 0.0;   ///< [length]
  double least_porosity = 0.0, least_permeability = 0.0;  ///< the latter over the virgin one [-]
  double greatest_breakage = 0.0;                         ///< 0 in rock without such a history
  double skin = 0.0;  ///< NaN in plane strain, which has no rings
};

/// Of every body of Arenisca in which the channel is open for more than four cells.
/// Collective; the same on every rank.
std::vector<RockZones> measure_zones(
    const Scene& scene, const State& state, const JetPath& path, const Penetration& found
);

/// Rock of a ring; NaN without any.
struct RingRock {
  double porosity, breakage;
};

/// Zones from the rings around a wall.
///
/// @param rings   from the wall outwards
/// @param virgin  porosity of the rock at the start
/// @param width   of a ring [length]
RockZones zones_of_rings(
    const std::vector<RingRock>& rings, double virgin, double wall, double width
);

}  // namespace barreno
