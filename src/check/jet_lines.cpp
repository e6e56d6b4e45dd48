// SPDX-License-Identifier: BSD-3-Clause
#include "check/jet_lines.hpp"

#include "check/format.hpp"
#include "output/jet/jet_estimate.hpp"

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

std::string depth_line(const Scene& scene) {
  if (estimate_jet(scene, scene.end_time).thinnest == 0.0) return {};
  return "Depth     error from the cells to expect at the end " +
         depth_doubt_text(depth_doubt(scene, scene.end_time)) + "\n";
}

}  // namespace

std::string jet_lines(const Scene& scene) {
  return scene.jet.present ? slug_line(scene) + depth_line(scene) : std::string();
}

}  // namespace barreno
