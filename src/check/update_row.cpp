// SPDX-License-Identifier: BSD-3-Clause
#include "check/update_row.hpp"

#include "step/particles/update_stress.hpp"

#include <variant>

namespace barreno {
namespace {

/// Laws of the general form; the others have one each.
const char* law_of(const AnyModel& any) {
  const auto* const general = std::get_if<GeneralArenisca>(&any);
  if (!general) return "";
  const GeneralArenisca::Parameters& p = general->parameters();
  if (p.return_solver != 0) return ", bisection";
  if (p.backstress_strain != GeneralArenisca::Parameters::plastic_backstress)
    return ", elastic centre";
  return p.undrained_moduli == GeneralArenisca::Parameters::arenisca3_moduli ? ", arenisca3"
                                                                             : ", plastic";
}

}  // namespace

std::string update_row(const Material& material) {
  return stress_label(material) + std::string(law_of(material.model));
}

std::optional<UpdateCost> update_cost(const Material& material, const CostTables& tables) {
  const auto found = tables.updates.find(update_row(material));
  if (found == tables.updates.end()) return {};
  return found->second;
}

}  // namespace barreno
