// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/body_force_section.hpp"

#include "deck/section_table.hpp"

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

constexpr Dimension acceleration{1, -2, 0, 0};

SectionTable<BodyForceSpec> body_force_table() {
  return {
      "Body Force",
      "a force per mass on every particle",
      Presence::optional,
      {needed(
           &BodyForceSpec::kind,
           "Kind",
           "gravity; or a manufactured motion of one Neo-Hookean body, whose exact displacement is "
           "known, to measure the error of the code: axis-aligned displacement of the unit box, "
           "generalized vortex and expanding ring of a hollow disk"
       ),
       if_given(&BodyForceSpec::acceleration, "Acceleration", acceleration, any(), "of gravity"),
       if_given(&BodyForceSpec::amplitude, "Amplitude", dim::length, any(), "of a displacement"),
       if_given(
           &BodyForceSpec::angle, "Angle", dim::none, any(), "amplitude of the vortex, radians"
       )}};
}

}  // namespace

template <>
const SectionTable<BodyForceSpec>& table_of<BodyForceSpec>() {
  static const SectionTable<BodyForceSpec> table = body_force_table();
  return table;
}

}  // namespace barreno
