// SPDX-License-Identifier: BSD-3-Clause
#include "deck/step_section.hpp"

#include "deck/shape_words.hpp"

#include <vector>

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

Bounds above_up_to(double a, double b) {
  return {a, b, true, false};
}

std::vector<Entry> support_entries() {
  return {
      word("Shape Function", shape_words(), "what a particle reads of the grid and gives to it")
          .by_default(shape_words().front()),
      number(
          "Largest Domain",
          dim::none,
          at_least(0.0),
          "l_crit, in cells, of the shape functions that deform with the particle (CPDI, "
          "contiguous GIMP): no corner of a domain is further from its centre; 0: as far as the "
          "tiles carry, slow"
      )
          .by_default("1")};
}

std::vector<Entry> limit_entries() {
  return {
      number("Courant Fraction", dim::none, above_up_to(0.0, 1.0), "of the critical step")
          .by_default("0.8"),
      flag(
          "Stable Alone",
          "steps in which particles stay stable that fly alone (stress last but with APIC): up to "
          "1.7 times as many, which whole bodies do not need"
      )
          .by_default("false"),
      number("Growth Limit", dim::none, above(1.0), "largest ratio of successive steps")
          .by_default("1.1"),
      number(
          "Largest Strain",
          dim::none,
          above_up_to(0.0, 1.0),
          "of one step; beyond it the step is retried smaller"
      )
          .by_default("0.5"),
      number(
          "Largest Expansion",
          dim::none,
          above(1.0),
          "volume over reference volume beyond which a particle is rubble and its policy acts"
      )
          .by_default("10")};
}

std::vector<Entry> scheme_entries() {
  return {
      word(
          "Transfer",
          {"FLIP", "PIC", "XPIC", "APIC"},
          "what particles take from the grid: FLIP its increments of velocity, PIC its velocity, "
          "XPIC the increments, without the part of their own velocity that the grid does not "
          "hold, APIC its velocity and how that varies around them"
      )
          .by_default("FLIP"),
      number("PIC Fraction", dim::none, between(0.0, 1.0), "of FLIP: 0 all FLIP, 1 all PIC")
          .by_default("0"),
      integer("XPIC Order", between(2, 5), "m of XPIC(m): the higher, the less it damps")
          .by_default("2"),
      word(
          "Order",
          {"stress last", "modified stress last", "stress first"},
          "when strains are found: from the velocities that forces gave, from those that "
          "accelerated particles give back to the grid, or from those that moved particles give "
          "it at the start of the next step"
      )
          .by_default("stress last"),
      flag(
          "Return Losses",
          "what a step takes from the energy of a metal (transfer and stress_integration of "
          "history.csv) becomes its heat; of FLIP, stress last, without damping"
      )
          .by_default("false")};
}

std::vector<Entry> remaining_entries() {
  return {
      number(
          "Damping",
          dim::rate,
          at_least(0.0),
          "force against every velocity, per momentum: lets a load settle to its static answer"
      )
          .by_default("0"),
      number(
          "Linear Viscosity",
          dim::none,
          at_least(0.0),
          "A1 in q = rho (A1 c h |tr D| + A2 h^2 (tr D)^2)"
      )
          .by_default("0.3"),
      number("Quadratic Viscosity", dim::none, at_least(0.0), "A2 in the same").by_default("2"),
      number("Initial Step", dim::time, at_least(0.0), "first step; 0: the stable one")
          .by_default("0"),
      number("Largest Step", dim::time, at_least(0.0), "limit of every step; 0: none")
          .by_default("0"),
      flag(
          "Skip Dormant Tiles",
          "particles at rest where no node moves are left as they are, where the scene allows it "
          "(`barreno check` says why not)"
      )
          .by_default("true"),
      number(
          "Rest Motion",
          dim::none,
          between(0.0, 1e-6),
          "what a node may move by in a step, in cells, without waking a tile at rest; 0: the "
          "answer is the same to the last bit; 1e-16, round-off, lets nearly all rock ahead of "
          "the wave rest. Without it 0 where all bodies start without stress, else 2^-53"
      )
          .if_given()};
}

}  // namespace

Section quasi_static_section() {
  return {
      "Quasi-Static",
      "slow loading in few steps: inertia is scaled, loads and weight are not, and what vibrates "
      "is "
      "damped critically unless Step/Damping says how; mass, momentum and kinetic energy of the "
      "output are those of the scaled inertia",
      Presence::optional,
      {number(
           "Transit Ratio",
           dim::none,
           above_up_to(0.0, 0.1),
           "time of a wave through the bodies over the time in which pore pressure diffuses "
           "through "
           "them (or the run, if that is shorter): answers are late by about three times as much"
       )
           .by_default("0.001"),
       number(
           "Inertia Factor",
           dim::none,
           at_least(1.0),
           "densities that move times this; chosen by Transit Ratio without it"
       )
           .if_given()},
      {},
      {}};
}

Section step_section() {
  std::vector<Entry> entries = support_entries();
  for (const auto& more : {limit_entries(), scheme_entries(), remaining_entries()})
    entries.insert(entries.end(), more.begin(), more.end());
  return {"Step", "how a step is taken", Presence::defaulted, entries, {}, {}};
}

}  // namespace barreno
