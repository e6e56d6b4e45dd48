// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/sections/jet_profile_section.hpp"
#include "deck/sections/jet_section.hpp"

#include <string>
#include <vector>

namespace barreno {

/// What is wrong with a profile, and of which of its entries.
struct ProfileProblem {
  std::string entry;     ///< name of the entry; empty: the profile as a whole
  std::string sentence;  ///< behind its value; empty: nothing is wrong
};
/// @param metal_density  of the jet's material [mass/length^3]
ProfileProblem problem_of_profile(const JetProfileSpec& profile, double metal_density);

/// Velocity below which metal has broken up when it crosses the launch plane, S / t_b; 0: none has.
double broken_below(const JetProfileSpec& profile);

/// Velocity below which slugs are pieces: broken_below(), or one between the tail and the slug of
/// the liner; 0: none is.
double pieces_below(const JetProfileSpec& profile);

/// Mass, momentum and kinetic energy of the jet, without the slug of the liner.
struct ProfileSums {
  double mass = 0.0, momentum = 0.0, kinetic = 0.0;
};
/// In closed form, of
///   dm/dv = rho pi r^2 min(S / v, t_b),   r linear in v between the radii of tip and tail.
ProfileSums sums_of_profile(const JetProfileSpec& profile, double metal_density);

/// The profile as slugs: velocities in equal ratios, mass and momentum those of the jet between two
/// of them, so that the whole table has both to round-off, and the kinetic energy to the order of
/// (ln ratio)^2 / 24. Whole metal touches: its slugs last from half-way to the slug before to
/// half-way to the slug behind. Pieces have the length t_b dv that they had when they broke. The
/// tip crosses the launch plane at t = 0.
/// @param profile  one without a problem
std::vector<JetSlug> slugs_of_profile(const JetProfileSpec& profile, double metal_density);

}  // namespace barreno
