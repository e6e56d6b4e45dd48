// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <Kokkos_Core.hpp>

#include <barreno/real.hpp>
#include <cmath>
#include <type_traits>

namespace barreno {

/// a b + c, where the processor can with one rounding.
KOKKOS_INLINE_FUNCTION double multiply_add(double a, double b, double c) {
#ifdef __FP_FAST_FMA
  return std::fma(a, b, c);
#else
  return a * b + c;
#endif
}

/// Artificial viscosity and the step that a particle allows; captured by value in kernels.
struct StableStepRule {
  double linear, quadratic, courant;
  double isolated_ratio;  ///< courant over the critical number c dt / h of a particle that is alone

  /// @param isolated_courant  of isolated_courant(), infinite if the step of the scene has no such
  /// limit
  StableStepRule(const StepSpec& step, Mode mode, double critical_courant, double isolated_courant)
      : linear(step.linear_viscosity),
        quadratic(step.quadratic_viscosity),
        // The critical number is that of a bar; diagonal modes of d dimensions are stiffer by sqrt
        // d.
        courant(step.courant_fraction * critical_courant / std::sqrt(dimensions(mode))),
        isolated_ratio(courant / isolated_courant) {}

  /// q = rho (A1 c h |tr D| + A2 h^2 (tr D)^2) in compression, else 0 [stress].
  template <class R>
  KOKKOS_INLINE_FUNCTION R
  viscous_pressure(const R& cell_size, const R& density, const R& modulus, const R& rate) const {
    const R h_rate = cell_size * real::larger(R(-rate), 0.0);
    // Of two products compilers round either alone, and for a single point another one whenever
    // the code around it changes.
    if constexpr (std::is_same_v<R, double>)
      return density * h_rate *
             multiply_add(linear, real::sqrt(modulus / density), quadratic * h_rate);
    else
      return density * h_rate * (linear * real::sqrt(R(modulus / density)) + quadratic * h_rate);
  }

  /// A rate of tr D at least as fast as the one that gave this viscous pressure, as stable_step
  /// takes it [1/time].
  KOKKOS_INLINE_FUNCTION double compression(double cell_size, double density, double viscous)
      const {
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
  KOKKOS_INLINE_FUNCTION R stable_step(
      const R& cell_size, const R& density, const R& modulus, const R& rate, const R& speed
  ) const {
    const R wave = wave_speed(cell_size, density, modulus, rate);
    const R alone = isolated_ratio * wave;
    const R whole = wave + speed;
    return courant * cell_size / real::select(alone > whole, alone, whole);
  }
  /// Q + sqrt(Q^2 + c^2) [velocity].
  template <class R>
  KOKKOS_INLINE_FUNCTION R
  wave_speed(const R& cell_size, const R& density, const R& modulus, const R& rate) const {
    const R c_squared = modulus / density;
    const R q = real::select(
        rate < 0.0, linear * real::sqrt(c_squared) - quadratic * cell_size * rate, 0.0
    );
    return q + real::sqrt(R(q * q + c_squared));
  }
};

}  // namespace barreno
