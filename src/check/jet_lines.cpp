// SPDX-License-Identifier: BSD-3-Clause
#include "check/jet_lines.hpp"

#include "base/format.hpp"
#include "jet/divided_error.hpp"
#include "jet/estimate.hpp"
#include "jet/kinds.hpp"
#include "jet/path.hpp"
#include "scene/jet.hpp"

#include <algorithm>

namespace barreno {
namespace {

std::string cells_text(const SlugCells& cells, const char* of) {
  if (cells.most == cells.least) return format("%.3g cells per %s", cells.tip, of);
  return format(
      "%.3g to %.3g cells per %s (tip %.3g, tail %.3g)",
      cells.least,
      cells.most,
      of,
      cells.tip,
      cells.tail
  );
}

std::string slug_line(const Scene& scene) {
  const std::vector<JetSlug>& slugs = scene.jet.slugs;
  const auto [slowest, fastest] =
      std::minmax_element(slugs.begin(), slugs.end(), [](const JetSlug& a, const JetSlug& b) {
        return a.velocity < b.velocity;
      });
  const bool plane = scene.grid.mode == Mode::plane_strain;
  return format(
             "Jet       %zu slug%s of %.4g to %.4g m/s, at impact ",
             slugs.size(),
             slugs.size() == 1 ? "" : "s",
             fastest->velocity,
             slowest->velocity
         ) +
         cells_text(slug_cells(scene, &JetSlug::radius), plane ? "half-width" : "radius") + ", " +
         cells_text(slug_cells(scene, &JetSlug::length), "length") + "\n";
}

/// Expansion beyond which the heat of a shock alone keeps the metal from its own density.
std::string porous_words(const MaterialSpec& material, double least_filled) {
  const double most = material.largest_porous_expansion();
  if (1.0 / least_filled < most) return {};
  return format(
      "; slugs with an expansion above 1 + 2 / Gruneisen = %.3g close, but stay below the metal's "
      "density behind a strong shock",
      most
  );
}

std::string kind_line(const Scene& scene) {
  const JetSpec& jet = scene.jet;
  const MaterialSpec& material = scene.materials[static_cast<std::size_t>(jet.material)];
  const std::vector<JetSlug>& table = jet.table.empty() ? jet.slugs : jet.table;
  const JetVoids voids = jet_voids(table, material.density());
  const JetTraits& traits = traits_of(jet.kind);
  std::string line = format(
      "Kind      %s: metal fills %.3g of the jet's length, at least %.3g of a slug's, %s",
      traits.word,
      voids.filled,
      voids.least_filled,
      traits.rest
  );
  if (traits.touching)
    line += format(
        "; hydrodynamic depth %.3g times that of the discrete jet",
        hydrodynamic_depth(table, jet.kind, scene.grid.mode, material.density())
    );
  if (traits.expanded) line += porous_words(material, voids.least_filled);
  return line + "\n";
}

/// What of the path no depth counts.
std::string liquid_line(const JetPath& path) {
  if (!path.has_target || !(path.liquid > 0.0)) return {};
  return format(
      "Liquid    %.4g mm of the jet's path; depth and hole are those in solids\n", 1e3 * path.liquid
  );
}

std::string error_line(const DepthDoubt& doubt) {
  return "Depth     expected error at the end from the size of the cells: " +
         depth_doubt_text(doubt) + "\n";
}

std::string depth_line(const Scene& scene) {
  const double end = expected_end(scene);
  if (estimate_jet(scene, end).thinnest == 0.0) return {};
  std::string line = error_line(depth_doubt(scene, end));
  if (!is_divided(scene)) return line;
  return line + "          of the hole as wide as the jet: " +
         depth_doubt_text(probed_depth_doubt(scene, end, Penetration{})) + "\n" +
         "          of its volume: " + depth_doubt_text(volume_doubt(scene, end, Penetration{})) +
         "\n";
}

/// When the hole of a run to rest is expected to be at rest.
std::string rest_line(const Scene& scene) {
  if (!scene.at_rest) return {};
  const double cut_off = cut_off_velocity(scene);
  const auto& slugs = scene.jet.slugs;
  const auto digs = std::count_if(slugs.begin(), slugs.end(), [&](const JetSlug& slug) {
    return slug.velocity >= cut_off;
  });
  const std::string depth =
      is_divided(scene)
          ? format(
                "%g times the depth of hydrodynamic theory, as holes of divided jets were found "
                "(docs/trade.md)",
                divided_depth_ratio
            )
          : "the depth of hydrodynamic theory (a real hole is deeper, and at rest later)";
  return format(
             "Rest      predicted at %.3g s: when the last of %td slugs of at least %.4g m/s "
             "(Cut-off Velocity) has dug, at ",
             predicted_rest(scene),
             digs,
             cut_off
         ) +
         depth + ", and a fifth of the time since the first contact has passed without growth\n";
}

}  // namespace

std::string jet_lines(const Scene& scene, const JetMonitorSpec& monitor) {
  if (scene.jet.present)
    return slug_line(scene) + kind_line(scene) + rest_line(scene) + liquid_line(jet_path(scene)) +
           depth_line(scene);
  const auto path = recorded_path(scene, monitor);
  if (!path) return {};
  return liquid_line(*path) + error_line(depth_doubt(scene, scene.end_time, Penetration{}));
}

}  // namespace barreno
