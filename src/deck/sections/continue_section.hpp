// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"
#include "deck/words.hpp"

#include <string>

namespace barreno {

/// What becomes of the velocities of the particles that are taken over.
enum class TakenVelocities { kept, at_rest };
inline Words<TakenVelocities> words_of(TakenVelocities /*of*/) {
  return {{"kept", TakenVelocities::kept}, {"at rest", TakenVelocities::at_rest}};
}

/// A deck that starts from the particles of a finished run.
struct ContinueSpec {
  std::string run;  ///< folder of that run; empty: the deck fills its bodies itself
  TakenVelocities velocities = TakenVelocities::kept;
  bool on() const { return !run.empty(); }
};
template <>
const SectionTable<ContinueSpec>& table_of<ContinueSpec>();

}  // namespace barreno
