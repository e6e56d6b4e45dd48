// SPDX-License-Identifier: BSD-3-Clause
#include "check/launched_jet.hpp"

#include "deck/section_table.hpp"

#include <nlohmann/json.hpp>

namespace barreno {
namespace {

using Json = nlohmann::ordered_json;

Json rows_of(const std::vector<JetSlug>& slugs) {
  Json rows = Json::array();
  for (const JetSlug& slug : slugs)
    rows.push_back(
        {{"time", slug.time},
         {"velocity", slug.velocity},
         {"radius", slug.radius},
         {"length", slug.length},
         {"density", slug.density},
         {"piece", slug.piece}}
    );
  return rows;
}

}  // namespace

std::string launched_jet_json(const Deck& deck, const Scene& scene) {
  if (!scene.jet.present)
    deck.refuse(
        table_of<JetSpec>().path, "is missing, so nothing is launched (--print-jet); give one"
    );
  const Json jet = {{"table", rows_of(scene.jet.table)}, {"slugs", rows_of(scene.jet.slugs)}};
  return jet.dump() + "\n";
}

}  // namespace barreno
