// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pore_flow/porous_medium.hpp"
#include "scene/porous.hpp"
#include "state/material_point.hpp"

#include <type_traits>
#include <variant>

namespace barreno {

/// visit(model) with the model of a material if it is porous.
template <class Visitor>
void visit_porous(const MaterialSpec& material, Visitor&& visit) {
  std::visit(
      [&](const auto& model) {
        if constexpr (is_drainable<std::decay_t<decltype(model)>>) visit(model);
      },
      material.material().model
  );
}

/// Fluid of a particle that has its initial mass, as volume at the initial density: fluid_mass of
/// that is what it has. All flow is counted so, which keeps the mass of a fluid that is compressed.
inline double fluid_volume(const MaterialSpec& rock, double mass, double initial_porosity) {
  return initial_porosity * mass / rock.density();
}

/// visit(row, its cell's number) for the rows of a set, tile by tile in the order of cells and ids;
/// debris, and rows that are about to be removed, are left out.
template <class Visitor>
void for_each_solid_row(const Grid& grid, const Particles& particles, Visitor&& visit) {
  for (int i = particles.tile_begin(0);
       i < particles.tile_begin(static_cast<std::size_t>(grid.active));
       ++i) {
    const int p = particles.order(i);
    if (!(particles.body(p) & debris_bit) && particles.fault(p) == Fault::none)
      visit(p, index_of(particles.key(p)));
  }
}

}  // namespace barreno
