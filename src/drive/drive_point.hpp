// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drive/drive_steps.hpp"
#include "drive/path_table.hpp"

#include <barreno/models.hpp>
#include <string>
#include <vector>

namespace barreno {

/// What a material point is like at one instant of its path.
struct DrivenRow {
  double time;                  ///< [s]
  Mat3 deformation_gradient;    ///< F [-]
  Sym3 stress;                  ///< Cauchy, tension positive, in the space frame [Pa]
  Sym3 unrotated;               ///< the same in the axes of the material, R^T stress R
  std::vector<double> history;  ///< in the order of the model's history table
};

/// One material point along a path: an answer for each row of the path, or each step.
///
/// At the first row the point is what a body of a scene is without confinement, initial_state(0):
/// unstressed and virgin, whatever F is there. That row is the reference configuration of the model
/// (V_ref, polar rotation). Between two rows the velocity gradient is
/// constant,
///   L dt = log(F1 F0^-1) / steps.per_row,   F <- exp(L dt) F,
/// and each step is that of a particle of the MPM (step/particles/update_deformation.cpp): the
/// model gets
///   d_eps = Rm^T sym(L dt) Rm,   ln(V / V_ref) <- ln(V / V_ref) + tr(L dt)
/// with Rm half-way between the polar rotations R of F before and after the step, and the stress of
/// the row is R sigma R^T. Where R does not change, d_eps is the exact logarithmic increment;
/// where it does, the error is of second order in the rotation of a step.
///
/// Throws DeckError with the line of two rows that no constant L connects in that sense (half a
/// turn), NumericalError with line and time where the model refuses a step.
/// @param source  name of the path, for sentences
std::vector<DrivenRow> drive_point(
    const Material& material,
    const std::vector<PathRow>& path,
    const DriveSteps& steps,
    const std::string& source
);

}  // namespace barreno
