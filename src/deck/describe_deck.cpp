// SPDX-License-Identifier: BSD-3-Clause
#include "deck/describe_deck.hpp"

#include "base/error.hpp"
#include "deck/deck_schema.hpp"
#include "deck/describe_entry.hpp"
#include "deck/describe_results.hpp"
#include "deck/describe_words.hpp"
#include "deck/search_words.hpp"

#include <barreno/input/nearest_name.hpp>
#include <barreno/input/scan_xml.hpp>
#include <sstream>

namespace barreno {
namespace {

using input::Entry;
using input::Presence;
using input::Section;

/// Lists of free name are there when they are written, so only fixed ones can be missing.
std::string presence_text(const Section& section) {
  if (section.name == "*") return "";
  return section.presence == Presence::required ? " (required)" : " (optional)";
}

void write_section(const Section& section, const std::string& path, std::ostream& out) {
  out << path << ": " << section.meaning << presence_text(section) << "\n";
  for (const Entry& entry : section.entries) write_entry(entry, out);
  for (const Section& part : section.sections) write_section(part, path + "/" + part.name, out);
  for (const Section& named : section.named) write_section(named, path + "/" + named.name, out);
}

void write_history(const HistoryField& field, std::ostream& out) {
  const std::string unit = input::si_unit_of(field.dimension);
  out << "      " << field.name << (unit.empty() ? "" : " [" + unit + "]") << ": " << field.meaning
      << '\n';
}

void write_model(const ModelDescription& model, std::ostream& out) {
  out << "Model \"" << model.name << "\": " << model.summary << '\n';
  for (const Entry& entry : card_section(model).entries) write_entry(entry, out, model.name);
  if (!model.history.empty()) out << "  history of every particle:\n";
  for (const HistoryField& field : model.history) write_history(field, out);
  if (model.more_history.empty()) return;
  out << "  and further history where the parameters ask for it:\n";
  for (const HistoryField& field : model.more_history) write_history(field, out);
}

constexpr const char* how_to_write =
    "A deck is a Teuchos ParameterList in XML: <ParameterList name=\"...\"> for a section,\n"
    "<Parameter name=\"End Time\" type=\"string\" value=\"120 us\"/> for a value. Plain numbers "
    "are in the system\n"
    "that Units names (default SI); a number with a unit suffix (\"12.7 mm\", \"10 ksi\", \"2.3 "
    "g/cm3\") is\n"
    "converted wherever a dimension is declared. Arrays are written \"{0 mm, -20 mm}\".\n";

void write_overview(std::ostream& out) {
  out << how_to_write << "\nAt the top of the deck:\n";
  for (const Entry& entry : deck_schema().entries) write_entry(entry, out);
  out << "\nSections:\n";
  for (const PlacedSection& placed : placed_sections()) {
    if (placed.section->name == "*") continue;
    out << "  " << placed.path << ": " << placed.section->meaning << presence_text(*placed.section)
        << "\n";
  }
  out << "\nModels:\n";
  for (const ModelDescription& model : describe_models()) {
    out << "  " << model.name << ": " << model.summary << '\n';
  }
  out << "\nbarreno describe NAME prints the table of a section or model, and what any parameter "
         "means, or any\nword of a run's files: barreno describe Grid, \"Pore Flow/Rocks\", "
         "Arenisca, Kozeny-Carman, channel_depth.\n";
}

/// What a name means in a deck: tables of sections, and single parameters.
void write_in_deck(const std::string& asked, std::ostream& out) {
  const auto write_entries = [&](const Section& section, const std::string& path) {
    for (const Entry& entry : section.entries) {
      if (!is_meant(asked, input::join(path, entry.name))) continue;
      out << (path.empty() ? "at the top of the deck" : path) << '\n';
      write_entry(entry, out);
    }
  };
  const std::vector<PlacedSection> sections = placed_sections();
  for (const PlacedSection& placed : sections)
    if (is_meant(asked, placed.path)) write_section(*placed.section, placed.path, out);
  write_entries(deck_schema(), "");
  for (const PlacedSection& placed : sections) write_entries(*placed.section, placed.path);
}

/// What it means in a card or as a history variable of a model.
void write_in_model(const ModelDescription& model, const std::string& asked, std::ostream& out) {
  if (is_asked(asked, model.name)) write_model(model, out);
  for (const Entry& entry : card_section(model).entries) {
    if (!is_asked(asked, entry.name)) continue;
    out << "Model \"" << model.name << "\"\n";
    write_entry(entry, out, model.name);
  }
  for (const auto& fields : {model.history, model.more_history})
    for (const HistoryField& field : fields) {
      if (!is_asked(asked, field.name)) continue;
      out << "Model \"" << model.name << "\", history of every particle\n";
      write_history(field, out);
    }
}

/// All that has a name.
void write_named(const std::string& asked, std::ostream& out) {
  write_in_deck(asked, out);
  for (const ModelDescription& model : describe_models()) write_in_model(model, asked, out);
  out << describe_result(result_page(), asked);
}

/// Where to look for a word that users search for, and what its names mean.
void write_search_word(const std::string& asked, std::ostream& out) {
  const SearchWord* const found = find_search_word(asked);
  if (found == nullptr) return;
  out << asked << ": " << found->answer << '\n';
  for (const char* const name : found->names)
    if (in_small_letters(name) != in_small_letters(asked)) write_named(name, out);
}

/// The nearest of all names, or those of sections and models where none is near.
std::string suggest_word(const std::string& asked) {
  std::vector<std::string> tables, all;
  for (const Section& section : deck_schema().sections) tables.push_back(section.name);
  for (const PlacedSection& placed : placed_sections()) {
    all.push_back(placed.path);
    for (const Entry& entry : placed.section->entries) all.push_back(entry.name);
  }
  for (const Entry& entry : deck_schema().entries) all.push_back(entry.name);
  for (const ModelDescription& model : describe_models()) {
    tables.push_back(model.name);
    for (const Entry& entry : card_section(model).entries) all.push_back(entry.name);
  }
  all.insert(all.begin(), tables.begin(), tables.end());
  const bool near = !input::nearest_name(asked, all).empty();
  return input::suggest_name(asked, near ? all : tables);
}

std::string cell(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

void write_rows(
    const std::vector<Entry>& entries, std::ostream& out, const std::string& model = {}
) {
  if (entries.empty()) return;
  out << "| name | value | bounds | default | meaning |\n|---|---|---|---|---|\n";
  for (const Entry& entry : entries) {
    const std::string text = default_text(entry);
    const std::string value = text.rfind("default: ", 0) == 0 ? text.substr(9) : text;
    out << "| " << cell(entry.name) << " | " << cell(type_text(entry)) << " | "
        << limits_text(entry, model) << " | " << cell(value) << " | " << cell(entry.meaning)
        << " |\n";
  }
  out << '\n';
}

void write_history_rows(
    const char* title, const std::vector<HistoryField>& fields, std::ostream& out
) {
  out << "| " << title << " | unit | meaning |\n|---|---|---|\n";
  for (const HistoryField& field : fields) {
    out << "| " << field.name << " | " << input::si_unit_of(field.dimension) << " | "
        << cell(field.meaning) << " |\n";
  }
  out << '\n';
}

void write_markdown_section(const Section& section, const std::string& path, std::ostream& out) {
  out << "## " << path << "\n\n" << section.meaning << presence_text(section) << ".\n\n";
  write_rows(section.entries, out);
  for (const Section& part : section.sections)
    write_markdown_section(part, path + "/" + part.name, out);
  for (const Section& named : section.named)
    write_markdown_section(named, path + "/" + named.name, out);
}

}  // namespace

std::string with_commas(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string describe_text(const std::string& name) {
  std::ostringstream out;
  if (name.empty()) {
    write_overview(out);
    return out.str();
  }
  write_named(name, out);
  if (out.str().empty()) write_named(in_small_letters(name), out);
  write_search_word(name, out);
  if (out.str().empty()) {
    throw DeckError(
        "describe " + input::shown(name) +
        " is neither a section, nor a model, nor a parameter, nor a word of a run's files "
        "(docs/output.md); " +
        suggest_word(name)
    );
  }
  return out.str();
}

std::string describe_markdown() {
  std::ostringstream out;
  out << "# Deck reference\n\nGenerated by `barreno describe --markdown` from the tables that "
         "validate decks; "
         "do not edit.\n\n"
      << how_to_write << "\n## Top of the deck\n\n";
  write_rows(deck_schema().entries, out);
  for (const Section& section : deck_schema().sections)
    write_markdown_section(section, section.name, out);
  for (const ModelDescription& model : describe_models()) {
    out << "## Model " << model.name << "\n\n" << model.summary << "\n\n";
    write_rows(card_section(model).entries, out, model.name);
    if (model.history.empty()) continue;
    write_history_rows("history", model.history, out);
    if (model.more_history.empty()) continue;
    write_history_rows("further history, where the parameters ask for it", model.more_history, out);
  }
  std::string text = out.str();
  text.pop_back();  // one newline at the end, not two
  return text;
}

}  // namespace barreno
