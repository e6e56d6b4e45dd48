// SPDX-License-Identifier: BSD-3-Clause
#include "check/notes.hpp"

#include "check/gap_notes.hpp"
#include "check/jet_note.hpp"
#include "check/liquid_note.hpp"
#include "check/locking_note.hpp"
#include "check/scale_notes.hpp"
#include "check/step_notes.hpp"
#include "check/wall_note.hpp"
#include "deck/material_notes.hpp"
#include "shape/shape_facts.hpp"

#include <barreno/input/scan_xml.hpp>
#include <utility>

namespace barreno {

std::vector<std::string> notes_of(const Deck& deck, const Scene& scene) {
  std::vector<std::string> notes = deck.notes;
  notes.insert(notes.end(), scene.left_out.begin(), scene.left_out.end());
  if (const char* const warning = shape_warning(scene)) notes.emplace_back(warning);
  for (int m = 0; m < static_cast<int>(scene.materials.size()); ++m)
    if (std::string note = locking_note(scene, m); !note.empty()) notes.push_back(std::move(note));
  for (std::string note :
       {ringing_note(scene),
        liquid_note(scene),
        largest_strain_note(scene),
        jet_note(scene),
        through_note(scene),
        early_end_note(scene),
        thin_slugs_note(scene),
        wall_note(scene)})
    if (!note.empty()) notes.push_back(std::move(note));
  for (const auto& find : {gap_notes, scale_notes})
    for (std::string& note : find(scene)) notes.push_back(std::move(note));
  for (std::string& note : material_notes(deck)) notes.push_back(std::move(note));
  // Notes may quote the user's words.
  for (std::string& note : notes) note = input::on_one_line(std::move(note));
  return notes;
}

}  // namespace barreno
