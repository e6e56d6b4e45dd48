// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/jet_monitor_section.hpp"

#include "deck/section_table.hpp"

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

SectionTable<JetMonitorSpec> jet_monitor_table() {
  return {
      "Jet Monitor",
      "a plane whose crossings by a formed jet are written as jet_table.csv, which Jet/Table reads",
      Presence::optional,
      {needed(
           &JetMonitorSpec::body_names,
           words("Bodies", {}, "names of lists in Bodies, all of one material: liners")
       ),
       needed(
           &JetMonitorSpec::position,
           "Position",
           dim::length,
           any(),
           "y of the plane, ahead of these bodies and of all explosive; one diameter of the charge "
           "ahead of it the jet is formed"
       ),
       needed(
           &JetMonitorSpec::direction,
           "Direction",
           Words<double>{{"+y", 1.0}, {"-y", -1.0}},
           "direction of flight"
       ),
       needed(
           &JetMonitorSpec::interval,
           "Interval",
           dim::time,
           above(0.0),
           "what crosses the plane within one becomes one slug; if slice_loss in summary.json is "
           "above 1e-3, it is too long"
       ),
       defaulted(
           &JetMonitorSpec::smallest_speed,
           "Smallest Speed",
           dim::velocity,
           at_least(0.0),
           "particles that cross with less are not of the jet (the slug of the liner)"
       ),
       if_given(
           &JetMonitorSpec::largest_radius,
           "Largest Radius",
           dim::length,
           above(0.0),
           "particles that cross farther from the axis are not of the jet; all are without it"
       )}};
}

}  // namespace

template <>
const SectionTable<JetMonitorSpec>& table_of<JetMonitorSpec>() {
  static const SectionTable<JetMonitorSpec> table = jet_monitor_table();
  return table;
}

}  // namespace barreno
