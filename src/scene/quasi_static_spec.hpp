// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

/// Inertia that is scaled so that slow loading takes few steps; loads and weight are not. docs/
/// method.md 8
struct QuasiStaticSpec {
  double inertia_factor = 1.0;  ///< densities that move times this; 1: true dynamics [-]
  double transit_time = 0.0;    ///< of a wave through the bodies with that inertia [time]
  double slow_time = 0.0;       ///< in which pressure diffuses through them, or the run [time]
  bool on() const { return transit_time > 0.0; }
};

}  // namespace barreno
