// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"
#include "deck/words.hpp"

#include <optional>
#include <string>

namespace barreno {

/// How particles take the grid's velocities: as increments (FLIP, blended with PIC), as they are
/// (PIC), as increments of velocities that the grid can hold (XPIC), or with their first moments
/// (APIC).
enum class Transfer { flip, pic, xpic, apic };
inline Words<Transfer> words_of(Transfer /*of*/) {
  return {
      {"FLIP", Transfer::flip},
      {"PIC", Transfer::pic},
      {"XPIC", Transfer::xpic},
      {"APIC", Transfer::apic}};
}

/// When of a step the strain is found: from the velocities that forces gave (stress last), from
/// those that the moved particles give back to the grid (modified stress last), or at the start of
/// the next step (stress first).
enum class Order { stress_last, modified_stress_last, stress_first };
inline Words<Order> words_of(Order /*of*/) {
  return {
      {"stress last", Order::stress_last},
      {"modified stress last", Order::modified_stress_last},
      {"stress first", Order::stress_first}};
}

/// Rest Motion where bodies start under stress: half of the distance from 1 to the next number, for
/// F = 1 does not change by a smaller strain [cells].
inline constexpr double stressed_rest_motion = 0x1p-53;

struct StepSpec {
  std::string shape = "GIMP";   ///< the word of one of the list in shape/visit_kernels.hpp
  double largest_domain = 1.0;  ///< l_crit: corners further from x_p are pulled in [cells]
  bool stable_alone = false;    ///< steps in which a particle is stable that flies alone
  double courant_fraction =
      0.8;                      ///< of the critical Courant number of shape and particles per cell
  double growth_limit = 1.1;    ///< largest ratio of successive steps
  double largest_strain = 0.5;  ///< per step: |D| dt stays below, the step is retried smaller [-]
  double largest_expansion = 10.0;  ///< V / V_ref beyond which the particle policy acts [-]
  Transfer transfer = Transfer::flip;
  double pic_fraction = 0.0;  ///< share of the grid's own velocity: 0 = FLIP, 1 = PIC, APIC
  int xpic_order = 2;         ///< m of XPIC(m), at least 2
  Order order = Order::stress_last;
  double damping = 0.0;               ///< f_I -= damping p_I [1/time]
  double linear_viscosity = 0.3;      ///< A1 of q = rho (A1 c h |tr D| + A2 h^2 (tr D)^2)
  double quadratic_viscosity = 2.0;   ///< A2
  double initial_step = 0.0;          ///< 0: the stable step [time]
  double largest_step = 0.0;          ///< 0: no limit [time]
  int subcycles = 1;                  ///< Subcycling::most
  bool return_losses = false;         ///< losses of a step become heat (scene/heat.hpp)
  bool skip_dormant = true;           ///< tiles at rest (scene/dormant.hpp)
  std::optional<double> rest_motion;  ///< of their nodes in a step; without: rest_motion() [cells]
};
template <>
const SectionTable<StepSpec>& table_of<StepSpec>();

/// The deck's word for a step's transfer: a FLIP that takes all of the grid's velocity is PIC.
inline std::string transfer_name(const StepSpec& step) {
  const bool pic = step.transfer == Transfer::flip && step.pic_fraction == 1.0;
  return word_of(pic ? Transfer::pic : step.transfer);
}

}  // namespace barreno
