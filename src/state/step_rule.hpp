// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <Kokkos_Core.hpp>

#include <barreno/real.hpp>
#include <cmath>

namespace barreno {

/// Artificial viscosity and the step that a particle allows; captured by value in kernels.
struct StepRule {
  double cell_size, linear, quadratic, courant;
  double lone_ratio;  ///< courant over the critical number c dt / h of a particle that is alone

  /// @param lone_courant  of lone_courant(), infinite if the step of the scene has no such limit
  StepRule(const Scene& scene, double critical_courant, double lone_courant)
      : cell_size(scene.grid.cell_size),
        linear(scene.step.linear_viscosity),
        quadratic(scene.step.quadratic_viscosity),
        // The critical number is that of a bar; diagonal modes of d dimensions are stiffer by sqrt
        // d.
        courant(
            scene.step.courant_fraction * critical_courant / std::sqrt(dimensions(scene.grid.mode))
        ),
        lone_ratio(courant / lone_courant) {}

  /// q = rho (A1 c h |tr D| + A2 h^2 (tr D)^2) in compression, else 0 [stress].
  template <class R>
  KOKKOS_INLINE_FUNCTION R
  viscous_pressure(const R& density, const R& modulus, const R& rate) const {
    const R h_rate = cell_size * real::larger(R(-rate), 0.0);
    return density * h_rate * (linear * real::sqrt(R(modulus / density)) + quadratic * h_rate);
  }

  /// A rate of tr D at least as fast as the one that gave this viscous pressure, as stable_step
  /// takes it [1/time].
  KOKKOS_INLINE_FUNCTION double compression(double density, double viscous) const {
    if (!(viscous > 0.0)) return 0.0;
    return quadratic > 0.0 ? -std::sqrt(viscous / (density * quadratic)) / cell_size : -1.0;
  }

  /// dt = C h / (Q + sqrt(Q^2 + c^2) + |v|), Q = A1 c + A2 h |tr D| the viscosity as a speed
  /// [time]; and no more than a particle that is alone bears, whose speed does not matter,
  /// C_alone h / (Q + sqrt(Q^2 + c^2)).
  ///
  /// Source of the form: viscous term of a damped oscillator's limit, J. Hallquist, LS-DYNA Theory
  /// (2006), "Time step control".
  template <class R>
  KOKKOS_INLINE_FUNCTION R
  stable_step(const R& density, const R& modulus, const R& rate, const R& speed) const {
    const R c_squared = modulus / density;
    const R q = real::select(
        rate < 0.0, linear * real::sqrt(c_squared) - quadratic * cell_size * rate, 0.0
    );
    const R wave = q + real::sqrt(R(q * q + c_squared));
    const R alone = lone_ratio * wave;
    const R whole = wave + speed;
    return courant * cell_size / real::select(alone > whole, alone, whole);
  }
};

}  // namespace barreno
