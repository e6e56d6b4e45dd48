// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drive/drive_steps.hpp"
#include "drive/mixed_path.hpp"

#include <barreno/models.hpp>
#include <string>
#include <vector>

namespace barreno {

/// What a material point is like at one instant of a path in strain and stress.
struct MixedAnswer {
  double time;                  ///< [s]
  Sym3 strain;                  ///< logarithmic, from the first row [-]
  Sym3 stress;                  ///< Cauchy, tension positive [Pa]
  std::vector<double> history;  ///< in the order of the model's history table
};

/// One material point under prescribed strains and stresses, virgin at the first row: an answer for
/// each row of the path, or each step.
///
/// Between two rows every value that the second prescribes changes linearly, in `steps.per_row`
/// steps, from what the first prescribed, or from what the point has become where the first
/// controlled that component by the other of strain and stress. In each step the
/// strains that are not prescribed are found by Newton's method with the update's tangent (less
/// what the fluid bears, where the pore pressure is prescribed), to 1e-8 of the largest stress; a
/// step that has no solution in reach is halved, ten times at most. On a drained path
/// fluid flows in or out at the end of each step until its pressure is the prescribed one, which is
/// first order in the steps where the rock yields.
///
/// Throws DeckError where a stress of the first row is not that of the virgin point or the model
/// holds no fluid, NumericalError with line, time, component and the stress that was reached where
/// a stress cannot be borne or the model refuses a step.
/// @param source  name of the path, for sentences
std::vector<MixedAnswer> drive_mixed(
    const Material& material,
    const MixedPath& path,
    const DriveSteps& steps,
    const std::string& source
);

}  // namespace barreno
