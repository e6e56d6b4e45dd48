// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/continue_section.hpp"

#include "deck/section_table.hpp"

namespace barreno {
namespace {

using namespace input;

SectionTable<ContinueSpec> continue_table() {
  return {
      "Continue",
      "a second stage: bodies start with the particles that a finished run left (barreno continue "
      "writes this list); time starts at 0",
      Presence::optional,
      {needed(
           &ContinueSpec::run,
           "Run",
           "folder of the finished run, relative to the deck; every body of the deck has the name "
           "and the shape of a body of that run"
       ),
       defaulted(
           &ContinueSpec::velocities,
           "Velocities",
           "of the particles: kept, or at rest (set to zero)"
       )}};
}

}  // namespace

template <>
const SectionTable<ContinueSpec>& table_of<ContinueSpec>() {
  static const SectionTable<ContinueSpec> table = continue_table();
  return table;
}

}  // namespace barreno
