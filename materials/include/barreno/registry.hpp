// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/input/schema.hpp"
#include "barreno/plausible.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_XMLObject.hpp>

#include <string>
#include <vector>

namespace barreno {

/// A model with its parameters. Whoever makes one or looks into it includes barreno/models.hpp,
/// which this header leaves out: names, tables and cards do not depend on the models' code.
struct Material;

/// The registry is generated from the list in models.hpp and from the models' own tables: what a
/// deck may say, what the manual prints and what hosts ask for have one source.

/// A model without its types.
struct ModelDescription {
  std::string name;
  std::string summary;
  std::vector<input::Entry> parameters;    ///< in the order of the model's table
  std::vector<HistoryField> history;       ///< in the order of the History struct
  std::vector<HistoryField> more_history;  ///< what its other forms have besides, in no order
  std::vector<PlausibleRange> plausible;   ///< that the model says itself
};

const std::vector<ModelDescription>& describe_models();

/// Throws InputError with the part of the sentence after the value, nearest name included.
const ModelDescription& find_model(const std::string& name);

inline constexpr int card_schema_version = 1;
inline constexpr const char* card_version_word = "Schema Version";  ///< its entry in a card

/// The table of a card of this model: schema version, units, source, model, density and its
/// parameters.
input::Section card_section(const ModelDescription& model);

/// The same as a Teuchos list with validators and documentation, for hosts that validate in
/// Teuchos' way. Required parameters are absent from it, because such a list can only say defaults.
Teuchos::ParameterList valid_parameters(const ModelDescription& model);

/// A material from values in SI; names, types, bounds and the model's own rules are checked.
/// @param source, path  where the list came from, for sentences: "deck.xml", "Materials/Steel"
Material make_material(
    const std::string& name,
    const Teuchos::ParameterList& list,
    const std::string& source = "material",
    const std::string& path = ""
);

/// A card's text or tree, scanned and checked against its model's table; values in SI.
Teuchos::ParameterList scan_card(const std::string& text, const std::string& source);
Teuchos::ParameterList scan_card(const Teuchos::XMLObject& card, const std::string& source);

/// A material from a card file. Throws FileError or InputError.
Material read_card(const std::string& file);

}  // namespace barreno
