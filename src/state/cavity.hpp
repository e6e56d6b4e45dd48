// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <vector>

namespace barreno {

/// The cavity in a ball that a load fills with pore fluid; of other loads all are 0.
struct Cavity {
  double volume = 0.0;          ///< now, the same on all ranks [length^3]
  double initial_volume = 0.0;  ///< at the start [length^3]
  double initial_radius = 0.0;  ///< [length]
  double wall_density = 0.0;    ///< of the ball's material at reference [mass/length^3]
  double bulk_modulus = 0.0;    ///< of the fluid [stress]
  int powers = 3;               ///< of the radius in the volume

  bool holds_fluid() const { return initial_volume > 0.0; }
};

/// The cavities of all loads at the start.
std::vector<Cavity> make_cavities(const Scene& scene);

}  // namespace barreno
