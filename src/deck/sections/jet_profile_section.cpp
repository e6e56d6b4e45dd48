// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/jet_profile_section.hpp"

#include "deck/section_table.hpp"

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

using P = JetProfileSpec;

/// Behind the tip and the tail.
void add_state_and_slug(Entries<P>& entries) {
  entries.push_back(if_given(
      &P::density,
      "Density",
      dim::density,
      above(0.0),
      "mean density as it crosses the launch plane, of a powder jet (Kind = continuous); left "
      "out: that of the material"
  ));
  entries.push_back(if_given(
      &P::break_up_time,
      "Break-up Time",
      dim::time,
      above(0.0),
      "since the virtual origin; metal that crosses the launch plane later is launched in "
      "pieces that no longer stretch, with gaps. Left out: the jet is whole"
  ));
  entries.push_back(
      defaulted(&P::rows, "Rows", between(2, 100000), "how many slugs the jet is cut into")
  );
  entries.push_back(if_given(
      &P::slug_velocity,
      "Slug Velocity",
      dim::velocity,
      above(0.0),
      "of the slug of the liner, which follows the tail in one piece"
  ));
  entries.push_back(
      if_given(&P::slug_mass, "Slug Mass", dim::mass, above(0.0), "of the slug of the liner")
  );
  entries.push_back(
      if_given(&P::slug_radius, "Slug Radius", dim::length, above(0.0), "of the slug of the liner")
  );
}

SectionTable<JetProfileSpec> jet_profile_table() {
  SectionTable<JetProfileSpec> table{
      "Jet/Profile",
      "a jet that has stretched freely from a virtual origin, in place of Table or Slugs "
      "(docs/jets.md)",
      Presence::optional,
      {needed(&P::tip_velocity, "Tip Velocity", dim::velocity, above(0.0), "of the foremost metal"),
       needed(
           &P::tail_velocity,
           "Tail Velocity",
           dim::velocity,
           above(0.0),
           "of the last metal, below Tip Velocity"
       ),
       needed(
           &P::virtual_origin,
           "Virtual Origin",
           dim::length,
           above(0.0),
           "distance before the launch plane from which all metal has flown since one time: the "
           "stand-off of the plane"
       ),
       if_given(
           &P::mass,
           "Mass",
           dim::mass,
           above(0.0),
           "of the jet without the slug of the liner; with it at most one of the radii is given"
       ),
       if_given(
           &P::tip_radius,
           "Tip Radius",
           dim::length,
           above(0.0),
           "of the metal as it crosses the launch plane, linear in the velocity from tip to tail; "
           "what is left out follows from Mass, of one radius if neither is given"
       ),
       if_given(&P::tail_radius, "Tail Radius", dim::length, above(0.0), "the same of the tail")}};
  add_state_and_slug(table.entries);
  return table;
}

}  // namespace

template <>
const SectionTable<JetProfileSpec>& table_of<JetProfileSpec>() {
  static const SectionTable<JetProfileSpec> table = jet_profile_table();
  return table;
}

}  // namespace barreno
