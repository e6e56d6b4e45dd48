// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/output_section.hpp"

#include "deck/section_table.hpp"
#include "deck/sections/time_section.hpp"

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

SectionTable<TimeSpec> time_table() {
  return {
      "Time",
      "duration of the run",
      Presence::required,
      {needed(&TimeSpec::end_time, "End Time", dim::time, above(0.0), "end of the run")}};
}

Entries<OutputSpec> interval_entries() {
  return {
      defaulted(
          &OutputSpec::field_interval,
          "Field Interval",
          dim::time,
          at_least(0.0),
          "between fields; 0: first and last only"
      ),
      defaulted(
          &OutputSpec::history_interval,
          "History Interval",
          dim::time,
          at_least(0.0),
          "between rows of history and depth; 0: every step; forces on rigid bodies are means over "
          "it"
      )};
}

Entries<OutputSpec> checkpoint_entries() {
  return {
      defaulted(
          within(&OutputSpec::checkpoint, &CheckpointSpec::wall_interval),
          "Checkpoint Wall Interval",
          dim::time,
          at_least(0.0),
          "wall-clock time between two checkpoints; 0: no limit. One is always written at the end "
          "of a run and on a signal"
      ),
      defaulted(
          within(&OutputSpec::checkpoint, &CheckpointSpec::interval),
          "Checkpoint Interval",
          dim::time,
          at_least(0.0),
          "likewise, in simulated time; 0: no limit"
      ),
      defaulted(
          within(&OutputSpec::checkpoint, &CheckpointSpec::steps),
          "Checkpoint Steps",
          at_least(0),
          "likewise, in steps; 0: no limit"
      )};
}

Entries<OutputSpec> particle_file_entries() {
  return {
      defaulted(&OutputSpec::glyph, "Particle Glyph", "particles as deformed cells or as points"),
      defaulted(
          &OutputSpec::files,
          "Particle Files",
          "one: particles.e; one per rank: particles.e.N.0 to .N-1 on N ranks, each written by one "
          "rank, which ParaView reads as one and barreno join makes one; by number: the latter "
          "above " +
              std::to_string(most_in_one_file / 1'000'000) + " million particles"
      )};
}

SectionTable<OutputSpec> output_table() {
  return {
      "Output",
      "what is written, and when",
      Presence::defaulted,
      joined<OutputSpec>({interval_entries(), checkpoint_entries(), particle_file_entries()})};
}

}  // namespace

template <>
const SectionTable<TimeSpec>& table_of<TimeSpec>() {
  static const SectionTable<TimeSpec> table = time_table();
  return table;
}

template <>
const SectionTable<OutputSpec>& table_of<OutputSpec>() {
  static const SectionTable<OutputSpec> table = output_table();
  return table;
}

}  // namespace barreno
