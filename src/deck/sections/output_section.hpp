// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"
#include "deck/words.hpp"

namespace barreno {

enum class Glyph { deformed, point };
inline Words<Glyph> words_of(Glyph /*of*/) {
  return {{"deformed", Glyph::deformed}, {"point", Glyph::point}};
}

/// More particles than this are written one file per rank where the deck leaves it to their number:
/// rank 0, which writes the one file, holds some 1 kB for each of them (docs/output.md).
inline constexpr long long most_in_one_file = 2'000'000;

/// Where particles are written: one file, or as many as the run began with ranks.
enum class ParticleFiles { by_number, one, one_per_rank };
inline Words<ParticleFiles> words_of(ParticleFiles /*of*/) {
  return {
      {"by number", ParticleFiles::by_number},
      {"one", ParticleFiles::one},
      {"one per rank", ParticleFiles::one_per_rank}};
}

/// What may pass between two checkpoints; 0: no bound.
struct CheckpointSpec {
  double wall_interval = 600.0;  ///< [s], of the clock on the wall
  double interval = 0.0;         ///< [time]
  long steps = 0;
};

struct OutputSpec {
  double field_interval = 0.0;  ///< between Exodus steps; 0: first and last only [time]
  double history_interval =
      0.0;  ///< between rows of history.csv and depth.csv; 0: every step [time]
  Glyph glyph = Glyph::deformed;
  ParticleFiles files = ParticleFiles::by_number;
  CheckpointSpec checkpoint;
};
template <>
const SectionTable<OutputSpec>& table_of<OutputSpec>();

}  // namespace barreno
