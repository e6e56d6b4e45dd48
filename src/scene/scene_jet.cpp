// SPDX-License-Identifier: BSD-3-Clause
#include "deck/section_table.hpp"
#include "scene/geometry.hpp"
#include "scene/jet.hpp"
#include "scene/jet_kinds.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>

namespace barreno {
namespace {

/// Where the widest and longest slug is when its centre crosses the plane.
Box launch_box(const JetSpec& jet, const GridSpec& grid) {
  double radius = 0.0, length = 0.0;
  for (const JetSlug& slug : jet.slugs) {
    radius = std::max(radius, slug.radius);
    length = std::max(length, slug.length);
  }
  const double y = jet.launch_position;
  Box box{{0.0, y - 0.5 * length, 0.0}, {radius, y + 0.5 * length, 0.0}};
  if (grid.mode != Mode::three_dimensional) return box;
  box.upper[2] = radius;
  for (const std::size_t across : {0U, 2U})
    if (grid.lower[across] < 0.0) box.lower[across] = -radius;
  return box;
}

const MaterialSpec& material_of_jet(const Scene& scene) {
  return scene.materials[static_cast<std::size_t>(scene.jet.material)];
}

void check_kind(const Deck& deck, const Scene& scene) {
  if (!traits_of(scene.jet.kind).expanded || material_of_jet(scene).holds_voids()) return;
  const std::string& name = material_of_jet(scene).name();
  deck.refuse_value(
      path_of(&JetSpec::kind),
      "needs a material that may have voids, which '" + name +
          "' may not (they are its Expansion Strain); write Materials/" + name +
          "/Expansion Strain = on, if it is Johnson-Cook, or take another kind"
  );
}

/// Slugs tear and collide: their particles have no volume in common.
void check_relaxation(const Deck& deck, const Scene& scene) {
  const MaterialSpec& material = material_of_jet(scene);
  if (material.volume_relaxation == 0.0) return;
  const std::string path =
      "Materials/" + material.name() + "/" + name_of(&MaterialSection::volume_relaxation);
  deck.refuse_value(
      path,
      "is of the jet's material, whose slugs tear and collide, so that the particles of a cell "
      "have "
      "no volume ratio in common; remove it, or give the bodies that need it a material of their "
      "own"
  );
}

}  // namespace

void add_jet(const Deck& deck, Scene& scene) {
  const std::string slugs = path_of(&JetSpec::slugs);
  if (!deck.has(slugs)) return;
  JetSpec& jet = scene.jet;
  jet = read_section<JetSpec>(deck);
  jet.present = true;
  jet.table_file = deck.jet_table;
  const std::string rows_path = jet.table_file.empty() ? slugs : path_of(&JetSpec::table_file);
  std::string problem;
  const double density = material_of_jet(scene).density();
  jet.table = table_slugs(deck.rows(slugs), density, problem);
  for (JetSlug& slug : jet.table)
    slug.piece = traits_of(jet.kind).touching && slug.velocity < jet.pieces_below;
  if (problem.empty()) problem = problem_of_kind(jet.table, jet.kind, density);
  if (!problem.empty()) deck.refuse_value(rows_path, problem);
  check_kind(deck, scene);
  check_relaxation(deck, scene);
  jet.slugs = slugs_of_kind(jet.table, jet.kind, scene.grid.mode, density);

  const Box place = launch_box(jet, scene.grid);
  const bool space = scene.grid.mode == Mode::three_dimensional;
  if (scene.grid.lower[0] > 0.0 || (space && scene.grid.lower[2] > 0.0)) {
    deck.refuse(
        table_of<JetSpec>().path,
        std::string("is launched along x = 0") + (space ? ", z = 0" : "") +
            ", which is outside the grid (its box begins beyond); extend Grid/Lower to 0"
    );
  }
  if (!inside(place, scene.grid)) {
    deck.refuse_value(
        path_of(&JetSpec::launch_position),
        "puts the launch plane outside the grid (every slug must fit into the grid box at launch); "
        "enlarge Grid or move the plane"
    );
  }
  for (const BodySpec& body : scene.bodies) {
    if (overlap(place, body.shape, scene.grid, scene.grid.cell_size / body.particles_per_cell)) {
      deck.refuse_value(
          path_of(&JetSpec::launch_position),
          "puts the launch plane into " + list_of<BodySpec>(body.name) +
              " (the jet is launched in free space); move the plane away from the body"
      );
    }
  }
}

}  // namespace barreno
