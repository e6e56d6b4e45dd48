// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/quasi_static_section.hpp"

#include "deck/section_table.hpp"

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

SectionTable<QuasiStaticSection> quasi_static_table() {
  return {
      "Quasi-Static",
      "slow loading in few steps: inertia is scaled, loads and weight are not, and vibrations are "
      "damped critically unless Step/Damping is given; mass, momentum and kinetic energy of the "
      "output are those of the scaled inertia",
      Presence::optional,
      {defaulted(
           &QuasiStaticSection::transit_ratio,
           "Transit Ratio",
           dim::none,
           above_up_to(0.0, 0.1),
           "time of a wave through the bodies over the time in which pore pressure diffuses "
           "through them (or that of the run, if shorter): answers lag by about three times this "
           "fraction"
       ),
       if_given(
           &QuasiStaticSection::inertia_factor,
           "Inertia Factor",
           dim::none,
           at_least(1.0),
           "factor on the densities in inertia; without it chosen by Transit Ratio"
       )}};
}

}  // namespace

template <>
const SectionTable<QuasiStaticSection>& table_of<QuasiStaticSection>() {
  static const SectionTable<QuasiStaticSection> table = quasi_static_table();
  return table;
}

}  // namespace barreno
