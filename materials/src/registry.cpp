// SPDX-License-Identifier: BSD-3-Clause
#include "barreno/registry.hpp"

#include "barreno/input/error.hpp"
#include "barreno/input/nearest_name.hpp"
#include "barreno/input/scan_xml.hpp"
#include "barreno/models.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <type_traits>
#include <utility>

namespace barreno {
namespace {

using input::Entry;
using Teuchos::ParameterList;

template <class T>
struct TypeOf {
  using type = T;
};

template <class Model>
std::vector<Entry> parameters_of() {
  std::vector<Entry> entries;
  const auto table = Model::parameter_table();
  for (const auto& p : table.numbers) {
    const Entry entry = input::number(p.name, p.dimension, p.bounds, p.meaning);
    entries.push_back(p.required ? entry : entry.by_default(input::exact_text(p.default_value)));
  }
  for (const auto& c : table.choices) {
    const auto index = static_cast<std::size_t>(c.default_index);
    entries.push_back(input::word(c.name, c.words, c.meaning).by_default(c.words.at(index)));
  }
  return entries;
}

template <class Model>
ModelDescription describe() {
  std::vector<PlausibleRange> plausible;
  if constexpr (says_plausible_ranges<Model>) plausible = Model::plausible_ranges();
  return {
      Model::name, Model::summary, parameters_of<Model>(), Model::history_table(), {}, plausible};
}

/// True for a model that stands in the list for some parameter sets of another.
template <class Model, class = void>
struct IsGeneralForm : std::false_type {};
template <class Model>
struct IsGeneralForm<Model, std::void_t<typename Model::SpecialForm>> : std::true_type {};

template <class Model, class Special>
bool serves(const typename Special::Parameters& p) {
  if constexpr (IsGeneralForm<Model>::value) {
    if constexpr (std::is_same_v<typename Model::SpecialForm, Special>) return Model::needed(p);
  }
  return false;
}

/// The model, or the form of it that this parameter set needs.
template <class Special, class... Models>
AnyModel form_for(
    const typename Special::Parameters& p, double density, const std::variant<Models...>* /*list*/
) {
  AnyModel built{Special(p, density)};
  const auto take = [&](auto type) {
    using Model = typename decltype(type)::type;
    if constexpr (std::is_same_v<typename Model::Parameters, typename Special::Parameters>) {
      if (serves<Model, Special>(p)) built = Model(p, density);
    }
  };
  (take(TypeOf<Models>{}), ...);
  return built;
}

template <class Model>
AnyModel build(const ParameterList& list, double density, std::string& problem) {
  typename Model::Parameters p{};
  const auto table = Model::parameter_table();
  for (const auto& number : table.numbers) p.*(number.member) = list.get<double>(number.name);
  for (const auto& choice : table.choices) {
    const auto& words = choice.words;
    const auto word = std::find(words.begin(), words.end(), list.get<std::string>(choice.name));
    p.*(choice.member) = static_cast<int>(word - words.begin());
  }
  problem = Model::check(p, density);
  // A model may count on a sound set, so an unsound one is never built; any other stands in until
  // the throw.
  return problem.empty() ? form_for<Model>(p, density, static_cast<const AnyModel*>(nullptr))
                         : AnyModel(LinearElastic({1.0, 1.0}, density));
}

bool stands_in(const std::vector<HistoryField>& list, const std::string& name) {
  return std::any_of(list.begin(), list.end(), [&](const HistoryField& field) {
    return field.name == name;
  });
}

/// The history of a card's other forms stands in the description of the model that users ask for.
template <class Model>
void add_general_history(std::vector<ModelDescription>& all) {
  if constexpr (IsGeneralForm<Model>::value) {
    for (ModelDescription& special : all) {
      if (special.name != Model::SpecialForm::name) continue;
      for (const HistoryField& field : Model::history_table())
        if (!stands_in(special.history, field.name) && !stands_in(special.more_history, field.name))
          special.more_history.push_back(field);
    }
  }
}

using Builder = AnyModel (*)(const ParameterList&, double, std::string&);

template <class... Models>
std::vector<ModelDescription> describe_all(const std::variant<Models...>* /*list*/) {
  std::vector<ModelDescription> all;
  const auto add = [&](auto type) {
    using Model = typename decltype(type)::type;
    if (!IsGeneralForm<Model>::value) all.push_back(describe<Model>());
  };
  (add(TypeOf<Models>{}), ...);
  (add_general_history<Models>(all), ...);
  return all;
}
template <class... Models>
std::vector<Builder> builders_of(const std::variant<Models...>* /*list*/) {
  std::vector<Builder> all;
  const auto add = [&](auto type) {
    using Model = typename decltype(type)::type;
    if constexpr (!IsGeneralForm<Model>::value) all.push_back(&build<Model>);
  };
  (add(TypeOf<Models>{}), ...);
  return all;
}

/// A value of a list as it would stand in a deck, so that one reader checks lists and texts alike.
std::string text_of(const Teuchos::ParameterEntry& entry) {
  if (entry.isType<double>()) return input::exact_text(Teuchos::getValue<double>(entry));
  if (entry.isType<int>()) return std::to_string(Teuchos::getValue<int>(entry));
  if (entry.isType<std::string>()) return Teuchos::getValue<std::string>(entry);
  return "a value of another type";
}

/// Names, types and bounds of a list in SI, defaults filled.
ParameterList checked(
    const ParameterList& list,
    const input::Section& section,
    const std::string& source,
    const std::string& path
) {
  Teuchos::XMLObject xml("ParameterList");
  for (auto item = list.begin(); item != list.end(); ++item) {
    Teuchos::XMLObject parameter("Parameter");
    parameter.addAttribute("name", list.name(item));
    parameter.addAttribute("value", text_of(list.entry(item)));
    xml.addChild(parameter);
  }
  return input::scan_list(xml, section, path, {source, {}});
}

const ModelDescription& model_named(
    const std::string& name, const std::string& source, const std::string& path
) {
  try {
    return find_model(name);
  } catch (const InputError& error) {
    input::refuse_value(source, input::join(path, "Model"), name, error.what());
  }
}

/// Rock whose pores a fluid fills is heavier than its card's density, that of the dry rock. Only
/// the mass changes, so this stands beside the density and not among the model's parameters.
constexpr const char* fluid_density_word = "Fluid Density";
bool may_hold_fluid(const std::string& model) {
  return model == Arenisca::name;
}

/// rho = rho_dry + phi rho_fluid with phi = 1 - exp(-p3) [kg/m3].
double density_at_start(
    const ParameterList& values, const std::string& source, const std::string& path
) {
  const double density = values.get<double>("Density");
  if (!values.isType<double>(fluid_density_word)) return density;
  const double fluid = values.get<double>(fluid_density_word);
  const double pores = values.get<double>("p3_crush_curve");
  if (values.get<double>("fluid_B0") <= 0.0 || pores <= 0.0) {
    input::refuse_value(
        source,
        input::join(path, fluid_density_word),
        input::exact_text(fluid),
        "needs pores with a fluid (p3_crush_curve and fluid_B0 above 0); set both, or remove it"
    );
  }
  return density - std::expm1(-pores) * fluid;
}

void check_version(int version, const std::string& source, const std::string& path) {
  if (version == card_schema_version) return;
  input::refuse_value(
      source,
      input::join(path, card_version_word),
      std::to_string(version),
      "is not the version that this program reads (" + std::to_string(card_schema_version) +
          "); convert the card or use the program that it was written for"
  );
}

}  // namespace

const std::vector<ModelDescription>& describe_models() {
  static const std::vector<ModelDescription> models =
      describe_all(static_cast<const AnyModel*>(nullptr));
  return models;
}

const ModelDescription& find_model(const std::string& name) {
  std::vector<std::string> known;
  for (const ModelDescription& model : describe_models()) {
    if (model.name == name) return model;
    known.push_back(model.name);
  }
  throw InputError("is not a known model; " + input::suggest_name(name, known));
}

input::Section card_section(const ModelDescription& model) {
  std::vector<std::string> names;
  for (const ModelDescription& each : describe_models()) names.push_back(each.name);
  input::Section section;
  section.name = "Card";
  section.meaning = model.summary;
  section.entries = {
      input::integer(card_version_word, any(), "version of this table")
          .by_default(std::to_string(card_schema_version)),
      input::text(input::units_word, "consistent system of the plain numbers, as in a deck")
          .by_default("SI"),
      input::text("Source", "source of the numbers").if_given(),
      input::word("Model", names, "constitutive model"),
      input::number("Density", dimension::density, above(0.0), "reference density")};
  if (may_hold_fluid(model.name))
    section.entries.push_back(
        input::number(
            fluid_density_word,
            dimension::density,
            above(0.0),
            "of the fluid in the pores (water: 1000 kg/m3); Density is then that of the dry rock, "
            "and the rock starts with Density + porosity x Fluid Density; without it Density is "
            "that of the rock with its fluid"
        )
            .if_given()
    );
  section.entries.insert(section.entries.end(), model.parameters.begin(), model.parameters.end());
  return section;
}

Material make_material(
    const std::string& name,
    const ParameterList& list,
    const std::string& source,
    const std::string& path
) {
  static const std::vector<Builder> builders = builders_of(static_cast<const AnyModel*>(nullptr));
  const std::string word = list.isType<std::string>("Model") ? list.get<std::string>("Model") : "";
  const ModelDescription& model = model_named(word, source, path);
  const ParameterList values = checked(list, card_section(model), source, path);
  check_version(values.get<int>(card_version_word), source, path);
  const double density = density_at_start(values, source, path);
  const auto index = static_cast<std::size_t>(&model - describe_models().data());
  std::string problem;
  AnyModel built = builders[index](values, density, problem);
  if (!problem.empty()) input::refuse(source, input::join(path, problem), "");
  return {name, density, built};
}

ParameterList scan_card(const std::string& text, const std::string& source) {
  return scan_card(input::parse_xml(text, source), source);
}

ParameterList scan_card(const Teuchos::XMLObject& xml, const std::string& source) {
  const std::string word = input::find_text(xml, "Model").value_or("");
  const input::UnitSystem units = input::units_of(xml, source);
  ParameterList list =
      input::scan_list(xml, card_section(model_named(word, source, "")), "", {source, units});
  check_version(list.get<int>(card_version_word), source, "");
  list.set(input::units_word, std::string("SI"));
  return list;
}

Material read_card(const std::string& file) {
  // Reading a pipe without a writer, or a device, would never end.
  std::error_code ignored;
  const bool plain = std::filesystem::is_regular_file(file, ignored);
  if (plain && std::filesystem::file_size(file, ignored) > input::largest_text)
    input::refuse(file, "", "is too large for a card; is it the right file?");
  std::ifstream stream;
  if (plain) stream.open(file);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!plain || !stream) {
    throw FileError(
        file + " cannot be read (it is absent or not readable); give the path of a card."
    );
  }
  const ParameterList list = scan_card(text.str(), file);
  const std::size_t slash = file.find_last_of('/');
  const std::string name = file.substr(slash == std::string::npos ? 0 : slash + 1);
  return make_material(name.substr(0, name.rfind(".xml")), list, file);
}

}  // namespace barreno
