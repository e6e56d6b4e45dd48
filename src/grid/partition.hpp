// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"

#include <array>
#include <vector>

namespace barreno {

/// What a parcel (parcels.hpp) costs in the two parts of a step between which ranks wait for each
/// other. (They wait once more within the first, for the halo: before and behind it the same
/// parcels are dear.)
struct ParcelCost {
  double nodes = 0.0;      ///< of its nodes, and of particles' sums to and from them
  double particles = 0.0;  ///< of its particles' motion, deformation and stress

  ParcelCost& operator+=(const ParcelCost& other) {
    nodes += other.nodes;
    particles += other.particles;
    return *this;
  }
  double total() const { return nodes + particles; }
};

/// Parcels to ranks by recursive coordinate bisection: across the longest side of those that cost
/// something, where the halves come nearest to the share of their ranks. Where the two parts of a
/// step cost most in different places, a half may be a slab out of the middle, and the other what
/// lies on both sides: so both parts can be halved (any two measures of a circle are, by one
/// interval). A cut may go through a slice. A pure function of its arguments, so that every rank
/// finds the same owners without communication; parcels that cost nothing go with their
/// surroundings. Of more ranks than parcels some get none. Of cuts that are as good, those are
/// taken that leave parcels where they are.
///
/// @param parcels  of the box, along x, y and z
/// @param costs    of every parcel of the box, z by z, row by row
/// @param now      rank of every parcel so far; empty: there was none
/// @return rank of every parcel
std::vector<int> bisect_parcels(
    const int (&parcels)[3],
    const std::vector<ParcelCost>& costs,
    int ranks,
    const std::vector<int>& now = {}
);

/// Sum over both parts of a step of what the rank costs that costs most.
double step_cost(const std::vector<int>& owner, const std::vector<ParcelCost>& costs, int ranks);

}  // namespace barreno
