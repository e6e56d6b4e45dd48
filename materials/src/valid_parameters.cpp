// SPDX-License-Identifier: BSD-3-Clause
#include "barreno/registry.hpp"

#include <Teuchos_StandardParameterEntryValidators.hpp>

#include <cmath>

namespace barreno {
namespace {

/// Teuchos' bounds are closed, so an open end is checked again by make_material.
Teuchos::RCP<const Teuchos::ParameterEntryValidator> validator_of(const Bounds& bounds) {
  auto validator = Teuchos::rcp(new Teuchos::EnhancedNumberValidator<double>());
  if (std::isfinite(bounds.lower)) validator->setMin(bounds.lower);
  if (std::isfinite(bounds.upper)) validator->setMax(bounds.upper);
  return validator;
}

}  // namespace

Teuchos::ParameterList valid_parameters(const ModelDescription& model) {
  Teuchos::ParameterList list(model.name);
  for (const input::Entry& entry : model.parameters) {
    if (entry.presence == input::Presence::required) continue;
    if (entry.kind == input::Kind::number) {
      list.set(
          entry.name, std::stod(entry.default_text), entry.meaning, validator_of(entry.bounds)
      );
    } else {
      const Teuchos::Array<std::string> words(entry.words);
      list.set(
          entry.name,
          entry.default_text,
          entry.meaning,
          Teuchos::rcp(new Teuchos::StringValidator(words))
      );
    }
  }
  return list;
}

}  // namespace barreno
