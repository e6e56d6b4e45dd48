// SPDX-License-Identifier: BSD-3-Clause
#include "deck/fidelity.hpp"

#include "deck/deck_schema.hpp"
#include "deck/describe_deck.hpp"

#include <Teuchos_ParameterList.hpp>

#include <barreno/input/error.hpp>
#include <barreno/input/scan_xml.hpp>
#include <cstdio>
#include <optional>

namespace barreno {
namespace {

using Teuchos::XMLObject;

struct Choices {
  const char* name;
  const char* shape;
  const char* transfer;
  const char* order;
  const char* courant;
  const char* per_cell;      ///< of bodies, per direction
  const char* jet_per_cell;  ///< of the jet, whose radius may be less than a cell
  const char* tolerance;     ///< of materials that integrate with a controlled error
  double fields, rows;       ///< instants of the output in a run; 0: first and last
  const char* errors;  ///< depth of a jet at cells of its radius / shock / smooth strains of 0.3
};

/// One row for each name. The numbers come from the curves of docs/trade.md.
constexpr Choices fidelities[] = {
    {"fast",
     "quadratic B-spline",
     "FLIP",
     "stress last",
     "0.9",
     "2",
     "2",
     "0.1",
     0.0,
     100.0,
     "16 %, 6 %, 3 %"},
    {"balanced",
     "GIMP",
     "FLIP",
     "stress last",
     "0.8",
     "2",
     "4",
     "0.01",
     20.0,
     500.0,
     "16 %, 11 %, 3 %"},
    {"reference",
     "CPDI",
     "FLIP",
     "stress last",
     "0.8",
     "2",
     "4",
     "0.001",
     50.0,
     2000.0,
     "18 %, 11 %, 0.6 %"},
};

const Choices* choices_of(const std::string& name) {
  for (const Choices& choices : fidelities)
    if (name == choices.name) return &choices;
  return nullptr;
}

/// A text as a deck would read it, in SI; nothing where it is no such number.
std::optional<double> value_of(
    const std::string& text, const Dimension& unit, const input::UnitSystem& units
) {
  const input::Entry entry = input::number("value", unit, any(), "");
  try {
    Teuchos::ParameterList list;
    input::put_value(list, entry, text, units);
    return list.get<double>("value");
  } catch (const InputError&) {
    return {};
  }
}

/// The deck's End Time; nothing where it is missing or no time, which is refused elsewhere.
std::optional<double> end_time(const XMLObject& root, const input::UnitSystem& units) {
  const auto time = input::find_list(root, "Time");
  const auto text = time ? input::find_text(*time, "End Time") : std::nullopt;
  return text ? value_of(*text, dimension::time, units) : std::nullopt;
}

std::string interval(double time, double instants) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g s", instants > 0.0 ? time / instants : 0.0);
  return text;
}

/// Whether two texts say the same: "0.80" and "0.8", "5 us" and "5e-06 s".
bool same(const std::string& a, const std::string& b, const input::UnitSystem& units) {
  if (a == b) return true;
  for (const Dimension& unit : {dimension::none, dimension::time}) {
    const auto first = value_of(a, unit, units), second = value_of(b, unit, units);
    if (first && first == second) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> fidelity_words() {
  std::vector<std::string> words;
  for (const Choices& choices : fidelities) words.emplace_back(choices.name);
  return words;
}

std::string fidelity_errors(const std::string& name) {
  const Choices* const choices = choices_of(name);
  return choices == nullptr ? "" : choices->errors;
}

std::string fidelity_text() {
  std::string text;
  for (const Choices& c : fidelities)
    text += (text.empty() ? "" : "; ") + std::string(c.name) + ": " + c.shape + ", " + c.transfer +
            ", " + c.order + ", Courant Fraction " + c.courant + ", " + c.per_cell +
            " particles per cell and direction, " + c.jet_per_cell + " in the jet, Tolerance " +
            c.tolerance + ", errors " + c.errors;
  return text;
}

// A name that is none is refused with the other words of the deck.
Fidelity::Fidelity(const std::string& name, const input::UnitSystem& units)
    : name_(choices_of(name) ? name : ""), units_(units) {}

void Fidelity::keep(const std::string& path, const std::string& said, const std::string& value) {
  kept_.push_back(path + " = " + said + " (" + name_ + ": " + value + ")");
}

void Fidelity::choose(
    const XMLObject& list,
    const std::string& path,
    const std::string& name,
    const std::string& value
) {
  const auto said = input::find_text(list, name);
  const std::string whole = input::join(path, name);
  if (said && !same(*said, value, units_)) return keep(whole, *said, value);
  if (!said) input::set_value(list, name, value);
  chosen_.push_back(whole + " = " + value);
}

void Fidelity::choose_for_deck(const XMLObject& root) {
  const Choices* const choices = choices_of(name_);
  if (choices == nullptr) return;
  const auto add_list = [&](const char* name) {
    if (!input::find_list(root, name)) {
      XMLObject list("ParameterList");
      list.addAttribute("name", std::string(name));
      XMLObject(root).addChild(list);
    }
    return *input::find_list(root, name);
  };
  const XMLObject step = add_list("Step");
  choose(step, "Step", "Shape Function", choices->shape);
  choose(step, "Step", "Transfer", choices->transfer);
  choose(step, "Step", "Order", choices->order);
  choose(step, "Step", "Courant Fraction", choices->courant);
  if (const auto bodies = input::find_list(root, "Bodies"))
    for (int i = 0; i < bodies->numChildren(); ++i) {
      const XMLObject& body = bodies->getChild(i);
      if (body.getTag() != "ParameterList" || !body.hasAttribute("name")) continue;
      const std::string path = input::join("Bodies", body.getAttribute("name"));
      choose(body, path, "Particles Per Cell", choices->per_cell);
    }
  if (const auto jet = input::find_list(root, "Jet"))
    choose(*jet, "Jet", "Particles Per Cell", choices->jet_per_cell);
  const auto time = end_time(root, units_);
  if (!time) return;
  const XMLObject output = add_list("Output");
  choose(output, "Output", "Field Interval", interval(*time, choices->fields));
  choose(output, "Output", "History Interval", interval(*time, choices->rows));
}

void Fidelity::choose_tolerance(
    const XMLObject& material, const std::string& path, const std::optional<std::string>& card
) {
  const Choices* const choices = choices_of(name_);
  if (choices == nullptr) return;
  const bool card_decides = card && !input::find_text(material, "Tolerance");
  if (card_decides && !same(*card, choices->tolerance, units_))
    return keep(input::join(path, "Tolerance"), *card, choices->tolerance);
  choose(material, path, "Tolerance", choices->tolerance);
}

std::vector<std::string> Fidelity::notes() const {
  if (name_.empty()) return {};
  std::vector<std::string> notes{"Fidelity " + name_ + ": " + with_commas(chosen_) + "."};
  if (!kept_.empty())
    notes.push_back(
        "The deck's own words come before fidelity " + name_ + ": " + with_commas(kept_) + "."
    );
  return notes;
}

}  // namespace barreno
