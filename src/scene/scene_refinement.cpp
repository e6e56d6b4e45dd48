// SPDX-License-Identifier: BSD-3-Clause
#include "deck/cells_of_jet.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/pore_flow_section.hpp"
#include "deck/sections/refinement_section.hpp"
#include "scene/jet.hpp"
#include "scene/scene_parts.hpp"
#include "scene/tile_levels.hpp"

#include <algorithm>
#include <string>

namespace barreno {
namespace {

RefinedRegion read_region(const Deck& deck, const std::string& name, const Scene& scene) {
  const std::string path = list_of<RefinedRegion>(name);
  auto region = read_list<RefinedRegion>(deck, path);
  region.shape = read_shape(deck, path, scene.grid.mode);
  return region;
}

RefinedRegion read_path(const Deck& deck, const Scene& scene) {
  RefinedRegion path = path_of_jet(scene.grid, scene.jet);
  const bool chosen = deck.chosen_by_fidelity.count(path_of(&JetSpec::cells_per_radius)) > 0;
  if (chosen) path.level = std::min(path.level, max_level);
  if (path.level > max_level) {
    deck.refuse_value(
        path_of(&JetSpec::cells_per_radius),
        "needs cells more than 2^" + std::to_string(max_level) +
            " times smaller than Grid/Cell Size (the most that the grid can be refined); choose a "
            "smaller Cell Size or fewer Cells Per Radius"
    );
  }
  return path;
}

/// A fidelity's refined path is left out where levels do not work.
bool leaves_path_out(const Deck& deck, Scene& scene) {
  const std::string path = path_of(&JetSpec::cells_per_radius),
                    conflict = conflict_with_levels(deck);
  if (conflict.empty() || deck.chosen_by_fidelity.count(path) == 0) return false;
  scene.left_out.push_back(
      "The fidelity's " + path + " is left out: " + conflict +
      " does not work across cells of different sizes yet."
  );
  return true;
}

bool asks_for_levels(const Deck& deck, const Scene& scene) {
  return !deck.lists(table_of<RefinedRegion>().path).empty() ||
         (scene.jet.present && scene.jet.cells_per_radius > 0.0);
}

}  // namespace

void add_refinement(const Deck& deck, Scene& scene) {
  if (asks_for_levels(deck, scene)) check_refined_size(deck, scene.grid);
  std::vector<RefinedRegion> regions;
  for (const std::string& name : deck.lists(table_of<RefinedRegion>().path)) {
    regions.push_back(read_region(deck, name, scene));
    const std::vector<unsigned char> levels = find_tile_levels(scene.grid, {regions.back()});
    if (std::all_of(levels.begin(), levels.end(), [](int level) { return level == 0; })) {
      deck.refuse(
          list_of<RefinedRegion>(name),
          "lies outside the grid (no cell would be refined); move the region or remove it"
      );
    }
  }
  if (scene.jet.present && scene.jet.cells_per_radius > 0.0 && !leaves_path_out(deck, scene)) {
    const RefinedRegion path = read_path(deck, scene);
    if (path.level > 0) regions.push_back(path);
  }
  scene.grid.level_of_tile = find_cheapest_levels(scene.grid, regions);
}

void check_refinement(const Deck& deck, const Scene& scene) {
  if (scene.grid.level_of_tile.empty()) return;
  const bool flows = scene.pore_flow.on();
  const std::string conflict =
      flows ? table_of<PoreFlowSpec>().path : conflict_with_levels(deck, true);
  if (conflict.empty()) return;
  const bool by_region = !deck.lists(table_of<RefinedRegion>().path).empty();
  deck.refuse(
      by_region ? table_of<RefinedRegion>().path : path_of(&JetSpec::cells_per_radius),
      "cannot be combined with " + conflict +
          " (which does not work across cells of different sizes yet); remove one of the two"
  );
}

}  // namespace barreno
