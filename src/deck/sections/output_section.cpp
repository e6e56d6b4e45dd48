// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/output_section.hpp"

#include "deck/section_table.hpp"
#include "deck/sections/time_section.hpp"

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

BoundEntry<TimeSpec> end_entry() {
  BoundEntry<TimeSpec> bound;
  bound.entry =
      number(
          "End Time",
          dim::time,
          above(0.0),
          "end of the run, or at rest: when the hole of the jet has stopped growing (docs/jets.md)"
      )
          .or_word(at_rest_word);
  bound.member = &TimeSpec::end_time;
  bound.read = [](const Deck& deck, const std::string& path, TimeSpec& spec) {
    spec.at_rest = deck.holds_word(path);
    if (!spec.at_rest) spec.end_time = deck.number(path);
  };
  bound.text = [](const TimeSpec& spec) {
    return spec.at_rest ? std::string(at_rest_word) : exact_text(spec.end_time);
  };
  return bound;
}

SectionTable<TimeSpec> time_table() {
  return {
      "Time",
      "duration of the run",
      Presence::required,
      {end_entry(),
       if_given(
           &TimeSpec::longest_time,
           "Longest Time",
           dim::time,
           above(0.0),
           "with End Time = at rest: end of the run in any case; left out: 1.5 times the time at "
           "which the last slug of the jet that still digs would reach the end of the grid in "
           "free flight"
       ),
       if_given(
           &TimeSpec::cut_off_velocity,
           "Cut-off Velocity",
           dim::velocity,
           above(0.0),
           "slower parts of the jet no longer dig: a hole can be at rest while they are on their "
           "way; left out: a fifth of the velocity of the fastest slug"
       )}};
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
