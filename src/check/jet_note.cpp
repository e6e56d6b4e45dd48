// SPDX-License-Identifier: BSD-3-Clause
#include "check/jet_note.hpp"

#include "check/format.hpp"
#include "output/depth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace barreno {
namespace {

/// When the first slug's leading face comes to the target in free flight [time].
double first_arrival(const Scene& scene, const JetPath& path) {
  double first = std::numeric_limits<double>::infinity();
  for (const JetSlug& slug : scene.jet.slugs) {
    const double way = std::abs(path.face - scene.jet.launch_position) - 0.5 * slug.length;
    first = std::min(first, slug.time + std::max(0.0, way) / slug.velocity);
  }
  return first;
}

}  // namespace

std::string jet_note(const Scene& scene) {
  if (!scene.jet.present) return {};
  const JetPath path = jet_path(scene);
  const char* const along = path.direction > 0.0 ? "+y" : "-y";
  if (!path.has_target)
    return format(
               "the jet hits no body (none lies in its path along %s from y = %g m), so no depth "
               "will be computed; ",
               along,
               scene.jet.launch_position
           ) +
           "if it should, reverse Jet/Direction, or move Jet/Launch Position or a body";
  const double arrival = first_arrival(scene, path);
  if (arrival < scene.end_time) return {};
  return format(
      "the jet reaches the target at %g s, not before Time/End Time = %g s, so no depth will be "
      "computed; choose a later End Time if it should",
      arrival,
      scene.end_time
  );
}

}  // namespace barreno
