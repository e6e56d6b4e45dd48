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
/// left, phi = 1 - (1 - phi_0) exp(-e), e the plastic volume strain; elastic strain is left out.
///
/// A ring is crushed or dilated where its porosity is more than 5 % of phi_0 away from it.
/// Permeability follows Kozeny and Carman, k ~ phi^3 / (1 - phi)^2, but is at least 1e-4 of the
/// virgin one; the skin is Hawkins' sum of (k_0/k - 1) ln(r_outer/r_inner) (Trans. AIME 207 (1956)
/// 356). Without a crushed or dilated ring its radii are those of the wall.
struct RockZones {
  std::size_t body = 0;                         ///< index into Scene::bodies
  double depth = 0.0, wall = 0.0;               ///< of the rings, and their inner radius [length]
  double crushed_from = 0.0, crushed_to = 0.0;  ///< [length]
  double dilated_to = 0.0;                      ///< [length]
  double least_porosity = 0.0, least_permeability = 0.0;  ///< the latter over the virgin one [-]
  double skin = 0.0;  ///< NaN in plane strain, which has no rings
};

/// Of every body of Arenisca in which the channel is open for more than four cells.
/// Collective; the same on every rank.
std::vector<RockZones> measure_zones(
    const Scene& scene, const State& state, const JetPath& path, const Penetration& found
);

/// Zones from the porosities of rings around a wall; NaN: a ring without rock.
///
/// @param porosity  from the wall outwards
/// @param virgin    porosity of the rock at the start
/// @param width     of a ring [length]
RockZones zones_of_rings(
    const std::vector<double>& porosity, double virgin, double wall, double width
);

}  // namespace barreno
