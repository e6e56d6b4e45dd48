// SPDX-License-Identifier: BSD-3-Clause
#include "jet/range_effects.hpp"

#include "base/format.hpp"
#include "files/measured_table.hpp"
#include "jet/path.hpp"
#include "scene/jet.hpp"

#include <algorithm>

namespace barreno {
namespace {

constexpr const char* file_name = "range_effects.csv";
constexpr std::size_t most_named = 2;

/// Parts of "card; parameter; range; known; until"; another number of another text.
std::vector<std::string> parts_of(const std::string& name) {
  const std::string between = "; ";
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = name.find(between); end != std::string::npos;
       begin = end + between.size(), end = name.find(between, begin))
    parts.push_back(name.substr(begin, end - begin));
  parts.push_back(name.substr(begin));
  return parts;
}

std::string take_rows(const MeasuredTable& table, std::vector<RangeEffect>& effects) {
  for (const MeasuredTable::Row& row : table.rows) {
    const std::vector<std::string> parts = parts_of(row.name);
    if (parts.size() != 5)
      return "\"" + row.name + "\" is no card, parameter, range, source and end";
    const std::vector<double>& n = row.numbers;
    if (std::any_of(n.begin(), n.end(), [](double change) { return change <= -1.0; }))
      return "a change of \"" + row.name + "\" leaves no hole";
    effects.push_back(
        {parts[0], parts[1], parts[2], parts[3], parts[4], {n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}}
    );
  }
  return effects.empty() ? "it has no rows" : "";
}

/// The card of a material by what its effective deck says of its numbers; empty: no card.
std::string card_of(const MaterialSpec& material) {
  const std::string begin = "card ", end = ".xml";
  std::string card = material.source;
  if (card.rfind(begin, 0) != 0) return {};
  card.erase(0, begin.size());
  const std::size_t at = card.rfind(end);
  return at == std::string::npos ? card : card.substr(0, at);
}

std::string percent_range(const RangeEffect::Change& change) {
  return format("%+.0f to %+.0f %%", 100.0 * change.at_low, 100.0 * change.at_high);
}

}  // namespace

RangeEffects read_range_effects(const std::filesystem::path& folder) {
  const MeasuredTable table = read_measured(
      file_name,
      {"range",
       "depth_at_low",
       "depth_at_high",
       "probed_depth_at_low",
       "probed_depth_at_high",
       "volume_at_low",
       "volume_at_high"},
      folder
  );
  RangeEffects effects{table.problem, {}};
  if (!effects.problem.empty()) return effects;
  const std::string why = take_rows(table, effects.rows);
  if (!why.empty())
    return {
        "the measured numbers of " + std::string(file_name) + " cannot be used: " + why,
        std::vector<RangeEffect>{}};
  return effects;
}

const RangeEffects& range_effects() {
  static const RangeEffects effects = read_range_effects();
  return effects;
}

LeastCertain least_certain(const Scene& scene, const RangeEffects& effects) {
  LeastCertain least;
  if (!scene.jet.present) return least;
  const BodySpec* body = longest_solid(scene);
  if (body == nullptr) return least;
  const std::string card = card_of(scene.materials[static_cast<std::size_t>(body->material)]);
  for (const RangeEffect& effect : effects.rows)
    if (effect.card == card && least.worst.size() < most_named) least.worst.push_back(effect);
  if (!least.worst.empty()) least.body = body->name;
  return least;
}

std::string least_certain_sentence(const LeastCertain& least) {
  std::string text;
  for (const RangeEffect& effect : least.worst)
    text += (text.empty() ? "least certain of " + least.body + ": " : "; ") + effect.parameter +
            " (" + effect.range + ", " + effect.known + ") changes the depth by " +
            percent_range(effect.depth) + ", the volume of the hole by " +
            percent_range(effect.volume);
  if (text.empty()) return text;
  return text + " (of perforation.xml to " + least.worst.front().until +
         ", docs/materials/arenisca.md)";
}

}  // namespace barreno
