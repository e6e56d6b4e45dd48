// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/step_section.hpp"

#include "deck/section_table.hpp"
#include "deck/shape_words.hpp"

#include <cmath>

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

Entries<StepSpec> support_entries() {
  return {
      defaulted(
          &StepSpec::shape,
          word("Shape Function", shape_words(), "weights between particles and nodes")
      ),
      defaulted(
          &StepSpec::largest_domain,
          "Largest Domain",
          dim::none,
          at_least(0.0),
          "l_crit, in cells, of the shape functions that deform with the particle (CPDI, "
          "contiguous GIMP): largest distance of a domain's corners from its centre; 0: as far as "
          "tiles allow, slow"
      )};
}

Entries<StepSpec> limit_entries() {
  return {
      defaulted(
          &StepSpec::courant_fraction,
          "Courant Fraction",
          dim::none,
          above_up_to(0.0, 1.0),
          "of the critical step"
      ),
      defaulted(
          &StepSpec::stable_alone,
          "Stable Alone",
          "steps small enough for isolated particles to stay stable (stress last, except with "
          "APIC): up to 1.7 times as many; coherent bodies do not need them"
      ),
      defaulted(
          &StepSpec::growth_limit,
          "Growth Limit",
          dim::none,
          above(1.0),
          "largest ratio of successive steps"
      ),
      defaulted(
          &StepSpec::largest_strain,
          "Largest Strain",
          dim::none,
          above_up_to(0.0, 1.0),
          "of one step; beyond it the step is retried with a smaller size"
      ),
      defaulted(
          &StepSpec::largest_expansion,
          "Largest Expansion",
          dim::none,
          above(1.0),
          "volume over reference volume beyond which a particle counts as rubble and Bad Particles "
          "applies"
      )};
}

Entries<StepSpec> scheme_entries() {
  return {
      defaulted(
          &StepSpec::transfer,
          "Transfer",
          "what particles take from the grid: FLIP its velocity increments, PIC its velocity, XPIC "
          "the increments, less the part of their own velocity that the grid cannot represent, "
          "APIC its velocity and the affine variation around them"
      ),
      defaulted(
          &StepSpec::pic_fraction,
          "PIC Fraction",
          dim::none,
          between(0.0, 1.0),
          "of FLIP: 0 all FLIP, 1 all PIC"
      ),
      defaulted(
          &StepSpec::xpic_order,
          "XPIC Order",
          between(2, 5),
          "m of XPIC(m): the higher, the less it damps"
      ),
      defaulted(
          &StepSpec::order,
          "Order",
          "when strains are computed: from the accelerated grid velocities, from those that "
          "accelerated particles return to the grid, or from those that moved particles return to "
          "it at the start of the next step"
      ),
      defaulted(
          &StepSpec::return_losses,
          "Return Losses",
          "numerical energy losses of a step in a metal, or rock with heat (transfer and "
          "stress_integration of "
          "history.csv) become its heat; with FLIP, stress last, without damping"
      )};
}

Entries<StepSpec> remaining_entries() {
  return {
      defaulted(
          &StepSpec::damping,
          "Damping",
          dim::rate,
          at_least(0.0),
          "drag force against every velocity, per momentum: a loaded body settles to its static "
          "answer"
      ),
      defaulted(
          &StepSpec::linear_viscosity,
          "Linear Viscosity",
          dim::none,
          between(0.0, 100.0),
          "A1 in q = rho (A1 c h |tr D| + A2 h^2 (tr D)^2)"
      ),
      defaulted(
          &StepSpec::quadratic_viscosity,
          "Quadratic Viscosity",
          dim::none,
          between(0.0, 100.0),
          "A2 in the same"
      ),
      defaulted(
          &StepSpec::initial_step,
          "Initial Step",
          dim::time,
          at_least(0.0),
          "first step; 0: the stable one"
      ),
      defaulted(
          &StepSpec::largest_step,
          "Largest Step",
          dim::time,
          at_least(0.0),
          "limit of every step; 0: none"
      )};
}

/// Of what tiles need not do in every step.
Entries<StepSpec> tile_entries() {
  return {
      defaulted(
          &StepSpec::skip_dormant,
          "Skip Dormant Tiles",
          "particles at rest where no node moves are skipped, where the scene allows it (`barreno "
          "check` says why not)"
      ),
      defaulted(
          &StepSpec::subcycles,
          "Subcycles",
          between(1, 16),
          "a power of two: tiles whose particles bear it take steps up to so many times as long as "
          "the smallest; 1: all take the smallest"
      ),
      if_given(
          &StepSpec::rest_motion,
          "Rest Motion",
          dim::none,
          between(0.0, 1e-6),
          "how far a node may move in a step, in cells, without waking a dormant tile; 0: the "
          "answer is the same to the last bit; 1e-16, round-off, keeps nearly all rock ahead of "
          "the wave dormant. Default 0 where all bodies start without stress, else 2^" +
              std::to_string(std::ilogb(stressed_rest_motion))
      )};
}

SectionTable<StepSpec> step_table() {
  return {
      "Step",
      "the time step and its numerical choices",
      Presence::defaulted,
      joined<StepSpec>(
          {support_entries(),
           limit_entries(),
           scheme_entries(),
           remaining_entries(),
           tile_entries()}
      )};
}

}  // namespace

template <>
const SectionTable<StepSpec>& table_of<StepSpec>() {
  static const SectionTable<StepSpec> table = step_table();
  return table;
}

}  // namespace barreno
