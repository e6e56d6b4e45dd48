// SPDX-License-Identifier: BSD-3-Clause
#include "jet/kinds.hpp"

#include "scene/jet_kinds.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {

JetVoids jet_voids(const std::vector<JetSlug>& table, double material_density) {
  JetVoids voids;
  double whole = 0.0, solid = 0.0, continuous = 0.0;
  for (const JetSlug& slug : touching_slugs(table)) {
    if (!(slug.length > 0.0)) return voids;
    const double filled = std::min(1.0, slug.density / material_density);
    whole += slug.length;
    solid += slug.length * filled;
    continuous += slug.length * filled * std::sqrt(2.0 / filled - 1.0);
    voids.least_filled = std::min(voids.least_filled, filled);
  }
  voids.filled = solid / whole;
  voids.thinned_depth = whole / solid;
  voids.continuous_depth = continuous / solid;
  return voids;
}

double digging_density(JetKind kind, const JetSlug& slug, double material_density) {
  if (kind != JetKind::continuous) return slug.density;
  return slug.density * (2.0 - slug.density / material_density);
}

}  // namespace barreno
