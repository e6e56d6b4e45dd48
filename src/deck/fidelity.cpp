// SPDX-License-Identifier: BSD-3-Clause
#include "deck/fidelity.hpp"

#include "deck/describe_deck.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/body_section.hpp"
#include "deck/sections/grid_section.hpp"
#include "deck/sections/jet_section.hpp"
#include "deck/sections/output_section.hpp"
#include "deck/sections/step_section.hpp"
#include "deck/sections/time_section.hpp"

#include <Teuchos_ParameterList.hpp>

#include <barreno/input/error.hpp>
#include <barreno/input/scan_xml.hpp>
#include <cstdio>
#include <optional>

namespace barreno {
namespace {

using Teuchos::XMLObject;

/// What a name chooses; what all of them choose alike is written here.
struct Choices {
  const char* name = "";
  const char* shape = "GIMP";
  Transfer transfer = Transfer::flip;
  Order order = Order::stress_last;
  double courant_fraction = 0.8;
  int per_cell = 2;                   ///< of bodies, per direction
  int jet_per_cell = 2;               ///< of the jet
  double tolerance = 0.01;            ///< of materials that integrate with a controlled error
  double fields = 0.0, rows = 0.0;    ///< instants of the output in a run; 0: first and last
  const char* errors = "";            ///< shock / smooth strains of 0.3, see fidelity_errors()
  const char* jet_shape = "GIMP";     ///< of decks with a jet
  double jet_courant_fraction = 0.8;  ///< of decks with a jet: that of Subcycles
  double jet_cells_per_radius = 0.0;  ///< along the jet's path
  double given_cells = 0.0;  ///< the same where the deck gives Grid/Cell Size; 0: its cells
  /// The same of metal that breaks, whose late slugs pile up (docs/trade.md, Depth at rest), ...
  double breaking_cells_per_radius = 0.0;
  int breaking_splits = 4;  ///< ... and how often its particles are divided
  /// Metal that breaks loses most to the grid where it is torn at the bottom of the hole.
  bool breaking_returns_losses = true;
  int path_per_cell = 1;  ///< of bodies, per direction, where it refines the path
  int jet_subcycles = 4;  ///< of decks with a jet
  /// Of decks with a jet. A particle of debris that runs into single others is strained so much in
  /// one step that it explodes: a kilojoule and more that nobody has put in (docs/method.md 4).
  double jet_largest_strain = 0.1;
};

constexpr Choices fast() {
  Choices choices;
  choices.name = "fast";
  choices.shape = "quadratic B-spline";
  choices.courant_fraction = 0.9;
  choices.tolerance = 0.1;
  choices.rows = 100.0;
  choices.errors = "6 %, 3 %";
  choices.jet_cells_per_radius = 1.8;
  choices.breaking_cells_per_radius = 1.2;
  choices.breaking_returns_losses = false;
  return choices;
}

constexpr Choices balanced() {
  Choices choices;
  choices.name = "balanced";
  choices.fields = 20.0;
  choices.rows = 500.0;
  choices.errors = "11 %, 3 %";
  choices.jet_cells_per_radius = 2.4;
  choices.given_cells = 2.0;
  choices.breaking_cells_per_radius = 1.8;
  return choices;
}

constexpr Choices reference() {
  Choices choices;
  choices.name = "reference";
  choices.shape = "CPDI";
  choices.tolerance = 0.001;
  choices.fields = 50.0;
  choices.rows = 2000.0;
  choices.errors = "11 %, 0.6 %";
  choices.jet_cells_per_radius = 4.0;
  choices.breaking_cells_per_radius = 2.4;
  choices.given_cells = 4.0;
  choices.path_per_cell = 2;
  return choices;
}

/// The numbers come from the curves of docs/trade.md.
constexpr Choices fidelities[] = {fast(), balanced(), reference()};

const Choices* choices_of(const std::string& name) {
  for (const Choices& choices : fidelities)
    if (name == choices.name) return &choices;
  return nullptr;
}

/// A text as a deck would read it for an entry, in SI; empty where that refuses it.
Teuchos::ParameterList value_of(
    const input::Entry& entry, const std::string& text, const input::UnitSystem& units
) {
  Teuchos::ParameterList list;
  try {
    input::put_value(list, entry, text, units);
  } catch (const InputError&) {
    return {};
  }
  return list;
}

/// Whether two texts say the same of an entry: "0.80" and "0.8", "5 us" and "5e-06 s".
bool same(
    const input::Entry& entry,
    const std::string& a,
    const std::string& b,
    const input::UnitSystem& units
) {
  const Teuchos::ParameterList first = value_of(entry, a, units);
  return a == b || (first.numParams() > 0 && first == value_of(entry, b, units));
}

/// The deck's End Time, or of a run to rest its Longest Time; nothing where they are missing or no
/// times, which is refused elsewhere.
std::optional<double> end_time(const XMLObject& root, const input::UnitSystem& units) {
  const auto time = input::find_list(root, table_of<TimeSpec>().path);
  if (!time) return {};
  for (const input::Entry& entry :
       {row_of<TimeSpec>(&TimeSpec::end_time).entry,
        row_of<TimeSpec>(&TimeSpec::longest_time).entry}) {
    const auto text = input::find_text(*time, entry.name);
    const auto list = text ? value_of(entry, *text, units) : Teuchos::ParameterList();
    if (list.isType<double>(entry.name)) return list.get<double>(entry.name);
  }
  return {};
}

/// Whether a list says nothing of an entry, or what it would be anyway.
template <class Spec, class T>
bool has_default(const XMLObject& list, T Spec::*member, const input::UnitSystem& units) {
  const input::Entry& entry = row_of<Spec>(member).entry;
  const auto said = input::find_text(list, entry.name);
  return !said || same(entry, *said, DeckValue<T>::text(Spec{}.*member), units);
}

/// Whether a step can return what it loses (check_returned_losses) on a grid where that was
/// verified with steps of several lengths.
bool can_return_losses(
    const XMLObject& root, const XMLObject& step, const input::UnitSystem& units
) {
  const auto grid = input::find_list(root, table_of<GridSpec>().path);
  const auto mode = grid ? input::find_text(*grid, name_of(&GridSpec::mode)) : std::nullopt;
  return mode != word_of(Mode::three_dimensional) &&
         has_default(step, &StepSpec::transfer, units) &&
         has_default(step, &StepSpec::pic_fraction, units) &&
         has_default(step, &StepSpec::order, units) && has_default(step, &StepSpec::damping, units);
}

bool gives_cell_size(const XMLObject& root) {
  const auto grid = input::find_list(root, table_of<GridSpec>().path);
  return grid && input::find_text(*grid, name_of(&GridSpec::cell_size)).has_value();
}

double interval(double time, double instants) {
  return instants > 0.0 ? time / instants : 0.0;
}

/// A choice as it is written in a deck; numbers to four digits, so that they can be read.
template <class T>
std::string choice_text(const T& value) {
  return DeckValue<T>::text(value);
}
std::string choice_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// Cells per radius of other decks, where they are others.
std::string other_cells_text(const Choices& choices) {
  const bool given =
      choices.given_cells > 0.0 && choices.given_cells != choices.jet_cells_per_radius;
  return " (" +
         (given ? choice_text(choices.given_cells) + " where Grid/Cell Size is given, " : "") +
         choice_text(choices.breaking_cells_per_radius) + " with " + name_of(&JetSpec::splits) +
         " " + choice_text(choices.breaking_splits) +
         (choices.breaking_returns_losses
              ? " and, in two dimensions, " + name_of(&StepSpec::return_losses)
              : std::string()) +
         " where the jet's metal breaks)";
}

}  // namespace

std::vector<std::string> fidelity_words() {
  std::vector<std::string> words;
  for (const Choices& choices : fidelities) words.emplace_back(choices.name);
  return words;
}

std::vector<std::string> fidelity_choices() {
  std::vector<std::string> words = fidelity_words();
  words.emplace_back("none");
  return words;
}

std::string fidelity_errors(const std::string& name) {
  const Choices* const choices = choices_of(name);
  return choices == nullptr ? "" : choices->errors;
}

std::string fidelity_text() {
  std::string text;
  for (const Choices& c : fidelities)
    text += (text.empty() ? "" : "; ") + std::string(c.name) + ": " + c.shape + ", " +
            word_of(c.transfer) + ", " + word_of(c.order) + ", " +
            name_of(&StepSpec::courant_fraction) + " " + choice_text(c.courant_fraction) + ", " +
            std::to_string(c.per_cell) + " particles per cell and direction, " +
            std::to_string(c.jet_per_cell) + " in the jet, Tolerance " + choice_text(c.tolerance) +
            "; with a jet " + c.jet_shape + ", " + name_of(&StepSpec::courant_fraction) + " " +
            choice_text(c.jet_courant_fraction) + ", " + name_of(&JetSpec::cells_per_radius) + " " +
            choice_text(c.jet_cells_per_radius) + other_cells_text(c) + " and " +
            std::to_string(c.path_per_cell) + " per cell and direction in bodies" +
            (c.given_cells > 0.0 ? ", " : " where Grid/Cell Size is left open, ") +
            name_of(&StepSpec::subcycles) + " " + std::to_string(c.jet_subcycles) + ", " +
            name_of(&StepSpec::largest_strain) + " " + choice_text(c.jet_largest_strain);
  return text;
}

// An unknown name is refused with the other words of the deck; "none" makes no choices.
Fidelity::Fidelity(const std::string& name, const input::UnitSystem& units)
    : name_(choices_of(name) ? name : ""), units_(units) {}

void Fidelity::keep(const std::string& path, const std::string& said, const std::string& value) {
  kept_.push_back(path + " = " + said + " (" + name_ + ": " + value + ")");
}

void Fidelity::choose(
    const XMLObject& list,
    const std::string& path,
    const input::Entry& entry,
    const std::string& value
) {
  const auto said = input::find_text(list, entry.name);
  const std::string whole = input::join(path, entry.name);
  if (said && !same(entry, *said, value, units_)) return keep(whole, *said, value);
  if (!said) input::set_value(list, entry.name, value);
  chosen_.push_back(whole + " = " + value);
  chosen_paths_.insert(whole);
}

template <class Spec, class T>
void Fidelity::choose(
    const XMLObject& list, const std::string& path, T Spec::*member, const T& value
) {
  const input::Entry& entry = row_of<Spec>(member).entry;
  choose(list, path, entry, with_unit(choice_text(value), entry));
}

void Fidelity::choose_for_step(const XMLObject& list, const std::string& path, bool jet) {
  const Choices& choices = *choices_of(name_);
  choose(list, path, &StepSpec::shape, std::string(jet ? choices.jet_shape : choices.shape));
  choose(list, path, &StepSpec::transfer, choices.transfer);
  choose(list, path, &StepSpec::order, choices.order);
  choose(
      list,
      path,
      &StepSpec::courant_fraction,
      jet ? choices.jet_courant_fraction : choices.courant_fraction
  );
  if (!jet) return;
  choose(list, path, &StepSpec::subcycles, choices.jet_subcycles);
  choose(list, path, &StepSpec::largest_strain, choices.jet_largest_strain);
}

void Fidelity::choose_for_jet(const XMLObject& list, bool given_size, bool breaks) {
  const Choices& choices = *choices_of(name_);
  const std::string path = table_of<JetSpec>().path;
  choose(list, path, &JetSpec::particles_per_cell, choices.jet_per_cell);
  double cells = given_size ? choices.given_cells : choices.jet_cells_per_radius;
  if (breaks) choose(list, path, &JetSpec::splits, choices.breaking_splits);
  if (breaks && cells > 0.0) cells = choices.breaking_cells_per_radius;
  if (cells > 0.0) choose(list, path, &JetSpec::cells_per_radius, cells);
}

void Fidelity::choose_for_deck(const XMLObject& root, bool jet_breaks) {
  const Choices* const choices = choices_of(name_);
  if (choices == nullptr) return;
  const auto add_list = [&](const std::string& name) {
    if (!input::find_list(root, name)) {
      XMLObject list("ParameterList");
      list.addAttribute("name", name);
      XMLObject(root).addChild(list);
    }
    return *input::find_list(root, name);
  };
  const std::string step = table_of<StepSpec>().path, output = table_of<OutputSpec>().path;
  const auto jet_list = input::find_list(root, table_of<JetSpec>().path);
  const XMLObject step_list = add_list(step);
  choose_for_step(step_list, step, jet_list.has_value());
  if (jet_list && jet_breaks && can_return_losses(root, step_list, units_))
    choose(step_list, step, &StepSpec::return_losses, choices->breaking_returns_losses);
  if (jet_list) choose_for_jet(*jet_list, gives_cell_size(root), jet_breaks);
  const bool refines = chosen_paths_.count(path_of(&JetSpec::cells_per_radius)) > 0;
  if (const auto bodies = input::find_list(root, table_of<BodySpec>().path))
    for (int i = 0; i < bodies->numChildren(); ++i) {
      const XMLObject& body = bodies->getChild(i);
      if (body.getTag() != "ParameterList" || !body.hasAttribute("name")) continue;
      const std::string path = list_of<BodySpec>(body.getAttribute("name"));
      choose(
          body,
          path,
          &BodySpec::particles_per_cell,
          refines ? choices->path_per_cell : choices->per_cell
      );
    }
  const auto time = end_time(root, units_);
  if (!time) return;
  const XMLObject list = add_list(output);
  choose(list, output, &OutputSpec::field_interval, interval(*time, choices->fields));
  choose(list, output, &OutputSpec::history_interval, interval(*time, choices->rows));
}

void Fidelity::choose_tolerance(
    const XMLObject& material,
    const std::string& path,
    const input::Entry& tolerance,
    const std::optional<std::string>& card
) {
  const Choices* const choices = choices_of(name_);
  if (choices == nullptr) return;
  const std::string value = choice_text(choices->tolerance);
  const bool card_decides = card && !input::find_text(material, tolerance.name);
  if (card_decides && !same(tolerance, *card, value, units_))
    return keep(input::join(path, tolerance.name), *card, value);
  choose(material, path, tolerance, value);
}

int Fidelity::particles_without_path() const {
  const Choices* const choices = choices_of(name_);
  return choices == nullptr ? 0 : choices->per_cell;
}

std::vector<std::string> Fidelity::notes() const {
  if (name_.empty()) return {};
  std::vector<std::string> notes{"Fidelity " + name_ + ": " + with_commas(chosen_) + "."};
  if (!kept_.empty())
    notes.push_back(
        "The deck's own values take precedence over fidelity " + name_ + ": " + with_commas(kept_) +
        "."
    );
  return notes;
}

}  // namespace barreno
