// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pore_flow/pore_network.hpp"

#include <vector>

namespace barreno {

/// What the drained correction did to this rank's particles.
struct DrainTally {
  /// Works on one material [energy].
  struct Works {
    double elastic = 0.0, plastic = 0.0;
  };
  std::vector<Works> materials;            ///< in the order of Scene::materials
  double fluid_before = 0.0, fluid = 0.0;  ///< in the pores, at the initial density [volume]
  double held = 0.0;                       ///< particles that could not take it and became debris
  double stops = 0.0;                      ///< the same of materials whose policy is to stop
};

/// Every particle of rock takes the change of its cell, and so much of the slope within the cell as
/// diffusion has made: (7.4)
///
///   dp_p = dp + (1 - exp(-pi^2 c dt / h^2)) (p + dp + G . (x_p - x) - p_p - dp)
///
/// with p, x means of weight V / M, so that what particles take adds up to what the cell takes.
/// Without flow nothing changes, bit for bit. No particle gives more than it holds; what its cell
/// still owes is taken from the others of the cell.
DrainTally drain_particles(const PorousMedium& medium, double dt, PoreNetwork& network);

}  // namespace barreno
