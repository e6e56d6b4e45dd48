// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"
#include "deck/words.hpp"

#include <optional>
#include <string>

namespace barreno {

class Deck;

/// What happens to a particle that went bad (inverted, not finite, failed material update).
enum class BadParticlePolicy { stop, hold, remove };
inline Words<BadParticlePolicy> words_of(BadParticlePolicy /*of*/) {
  return {
      {"remove", BadParticlePolicy::remove},
      {"hold", BadParticlePolicy::hold},
      {"stop", BadParticlePolicy::stop}};
}

/// What every list below Materials may hold besides its model's parameters.
struct MaterialSection {
  std::optional<std::string> card;  ///< its file
  BadParticlePolicy bad_particles = BadParticlePolicy::remove;
  std::optional<double> largest_expansion;  ///< V / V_ref; without: the model's or the step's
  std::optional<double> volume_relaxation;  ///< of a cell's particles, per shear strain [-]
};
template <>
const SectionTable<MaterialSection>& table_of<MaterialSection>();

/// Index of the material that the parameter at `path` names. @throws DeckError if none has that
/// name
int material_at(const Deck& deck, const std::string& path);

}  // namespace barreno
