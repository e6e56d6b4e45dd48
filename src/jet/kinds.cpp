// SPDX-License-Identifier: BSD-3-Clause
#include "jet/kinds.hpp"

#include "scene/jet_kinds.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {

JetVoids jet_voids(const std::vector<JetSlug>& table, double material_density) {
  JetVoids voids;
  double whole = 0.0, solid = 0.0;
  for (const JetSlug& slug : touching_slugs(table)) {
    if (!(slug.length > 0.0)) return voids;
    const double filled = std::min(1.0, slug.density / material_density);
    whole += slug.length;
    solid += slug.length * filled;
    voids.least_filled = std::min(voids.least_filled, filled);
  }
  voids.filled = solid / whole;
  return voids;
}

double hydrodynamic_depth(
    const std::vector<JetSlug>& table, JetKind kind, Mode mode, double material_density
) {
  double solid = 0.0, depth = 0.0;
  for (const JetSlug& row : table) solid += row.length * row.density / material_density;
  for (const JetSlug& slug : slugs_of_kind(table, kind, mode, material_density))
    depth +=
        slug.length * std::sqrt(digging_density(kind, slug, material_density) / material_density);
  return solid > 0.0 ? depth / solid : 1.0;
}

double digging_density(JetKind kind, const JetSlug& slug, double material_density) {
  if (!traits_of(kind).expanded) return slug.density;
  return slug.density * (2.0 - slug.density / material_density);
}

}  // namespace barreno
