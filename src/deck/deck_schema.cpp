// SPDX-License-Identifier: BSD-3-Clause
#include "deck/deck_schema.hpp"

#include "deck/section_table.hpp"
#include "deck/sections/body_force_section.hpp"
#include "deck/sections/body_section.hpp"
#include "deck/sections/contact_section.hpp"
#include "deck/sections/continue_section.hpp"
#include "deck/sections/detonation_section.hpp"
#include "deck/sections/grid_section.hpp"
#include "deck/sections/head_section.hpp"
#include "deck/sections/jet_monitor_section.hpp"
#include "deck/sections/jet_section.hpp"
#include "deck/sections/load_sections.hpp"
#include "deck/sections/material_section.hpp"
#include "deck/sections/output_section.hpp"
#include "deck/sections/pore_flow_section.hpp"
#include "deck/sections/quasi_static_section.hpp"
#include "deck/sections/refinement_section.hpp"
#include "deck/sections/shape_section.hpp"
#include "deck/sections/step_section.hpp"
#include "deck/sections/time_section.hpp"

#include <algorithm>

namespace barreno {
namespace {

input::Section build_schema() {
  input::Section materials = section_of<MaterialSection>();
  materials.named_read_elsewhere = true;
  input::Section deck = section_of<HeadSection>();
  deck.name = "Deck";
  deck.sections = {
      section_of<GridSpec>(),
      refinement_section(),
      materials,
      section_of<ShapeSection>(),
      bodies_section(),
      section_of<ContinueSpec>(),
      section_of<ConditionSpec>(),
      section_of<PressureLoadSpec>(),
      section_of<ConfinementSection>(),
      jet_section(),
      section_of<JetMonitorSpec>(),
      detonation_section(),
      section_of<BodyForceSpec>(),
      section_of<ContactSpec>(),
      pore_flow_section(),
      section_of<StepSpec>(),
      section_of<QuasiStaticSection>(),
      section_of<TimeSpec>(),
      section_of<OutputSpec>()};
  return deck;
}

}  // namespace

const input::Section& deck_schema() {
  static const input::Section schema = build_schema();
  return schema;
}

input::Section material_section(const ModelDescription& model) {
  input::Section section = card_section(model);
  // The deck sets these once, for everything in it.
  const std::string& version = name_of(&HeadSection::schema_version);
  const std::string& units = name_of(&HeadSection::units);
  auto& entries = section.entries;
  entries.erase(
      std::remove_if(
          entries.begin(),
          entries.end(),
          [&](const auto& e) { return e.name == version || e.name == units; }
      ),
      entries.end()
  );
  const auto common = entries_of<MaterialSection>();
  entries.insert(entries.begin(), common.begin(), common.end());
  return section;
}

}  // namespace barreno
