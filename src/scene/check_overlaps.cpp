// SPDX-License-Identifier: BSD-3-Clause
#include "deck/section_table.hpp"
#include "scene/geometry.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <vector>

namespace barreno {
namespace {

/// A body and what its box takes of an axis.
struct Extent {
  std::size_t body;
  double lower, upper;
};

std::vector<Extent> extents_along(const Scene& scene, std::size_t axis) {
  std::vector<Extent> extents;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Box box = box_around(scene.bodies[b].shape, scene.grid);
    extents.push_back({b, box.lower[axis], box.upper[axis]});
  }
  std::sort(extents.begin(), extents.end(), [](const Extent& a, const Extent& b) {
    return a.lower != b.lower ? a.lower < b.lower : a.body < b.body;
  });
  return extents;
}

/// visit(a, b) for the bodies whose boxes meet along the axis of sorted extents, until it is true.
template <class Visitor>
void for_each_meeting(const std::vector<Extent>& extents, Visitor&& visit) {
  for (std::size_t i = 0; i < extents.size(); ++i)
    for (std::size_t j = i + 1; j < extents.size() && extents[j].lower <= extents[i].upper; ++j)
      if (visit(extents[i].body, extents[j].body)) return;
}

/// Number of pairs of boxes that overlap along an axis; counting stops once it is large enough.
std::size_t count_meetings(const std::vector<Extent>& extents) {
  const std::size_t enough = 1000 + 10 * extents.size();
  std::size_t count = 0;
  for_each_meeting(extents, [&](std::size_t, std::size_t) { return ++count > enough; });
  return count;
}

/// Along the axis on which boxes meet least: of many bodies few pairs are left to look at.
std::vector<Extent> sparsest_extents(const Scene& scene) {
  std::vector<Extent> best = extents_along(scene, 0);
  std::size_t least = count_meetings(best);
  for (std::size_t axis = 1; axis < static_cast<std::size_t>(dimensions(scene.grid.mode)); ++axis) {
    std::vector<Extent> extents = extents_along(scene, axis);
    const std::size_t count = count_meetings(extents);
    if (count >= least) continue;
    least = count;
    best = std::move(extents);
  }
  return best;
}

}  // namespace

void check_overlaps(const Deck& deck, const Scene& scene) {
  for_each_meeting(sparsest_extents(scene), [&](std::size_t a, std::size_t b) {
    const BodySpec& first = scene.bodies[std::min(a, b)];
    const BodySpec& second = scene.bodies[std::max(a, b)];
    const int finer = std::max(first.particles_per_cell, second.particles_per_cell);
    if (overlap(second.shape, first.shape, scene.grid, scene.grid.cell_size / finer))
      deck.refuse(
          list_of<BodySpec>(second.name),
          "overlaps Bodies/" + first.name +
              " (the same space would be filled twice); move or shrink one of them"
      );
    return false;
  });
}

}  // namespace barreno
