// SPDX-License-Identifier: BSD-3-Clause
#include "pore_flow/pore_cells.hpp"

#include "base/region.hpp"
#include "pore_flow/porous_points.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace barreno {
namespace {

/// The id of the cell with this key.
long long id_of_key(const Grid& grid, int key) {
  const Patch& patch = grid.patch;
  const TilePosition& tile = grid.tile_frame(static_cast<std::size_t>(key / patch.cells)).position;
  int inside = key % patch.cells;
  long long at[3] = {0, 0, 0};
  for (int d = 0; d < patch.dimensions; ++d, inside >>= patch.tile_bits)
    at[d] = static_cast<long long>(tile[d]) * patch.tile_cells + inside % patch.tile_cells;
  return (at[2] * grid.cells[1] + at[1]) * grid.cells[0] + at[0];
}

/// Jets flow: what they fill is open to the fluid.
bool is_solid(const PorousMedium& medium, const Particles& particles) {
  return particles.material != medium.jet_material;
}

/// Cells with something solid get their place in the list, in the order of keys.
void number_cells(const PorousMedium& medium, PoreCells& cells) {
  const Grid& grid = medium.grid;
  const auto keys =
      static_cast<std::size_t>(grid.active) * static_cast<std::size_t>(grid.patch.cells);
  cells.index_of_key.assign(keys, -1);
  for (const Particles& particles : medium.particles)
    if (is_solid(medium, particles))
      for_each_solid_row(grid, particles, [&](int, int key) {
        cells.index_of_key[static_cast<std::size_t>(key)] = 0;
      });
  cells.own = 0;
  cells.ids.clear();
  for (std::size_t key = 0; key < keys; ++key) {
    if (cells.index_of_key[key] < 0) continue;
    cells.index_of_key[key] = cells.own++;
    cells.ids.push_back(id_of_key(grid, static_cast<int>(key)));
  }
}

/// (phi / phi0)^3 ((1 - phi0) / (1 - phi))^2
double kozeny_carman(double porosity, double first) {
  const double pores = porosity / first, grains = (1.0 - first) / (1.0 - porosity);
  return pores * pores * pores * grains * grains;
}

/// Half the length of a deformed particle along each axis.
Vector half_lengths(const Particles& particles, int p) {
  const int dimensions = particles.position.components;
  Vector half{};
  for (int d = 0; d < dimensions; ++d)
    for (int e = 0; e < dimensions; ++e)
      half[static_cast<std::size_t>(d)] +=
          std::abs(particles.deformation_gradient(p, d * dimensions + e)) *
          particles.half_size(p, e);
  return half;
}

/// Counts a particle of rock; the means are sums until all are counted.
///
/// @param storage   1/M of the point, of full pores where the solve fills its gap [1/stress]
/// @param capacity  what a particle's volume of its fluid is at the initial density [volume]
void count_point(
    const Particles& particles,
    int p,
    double pressure,
    double storage,
    double capacity,
    const Vector& mobility,
    PoreCell& cell
) {
  const double volume = particles.volume(p), weight = capacity * storage;
  const Vector x = vector_of(particles.position, p), half = half_lengths(particles, p);
  cell.storage += weight;
  cell.pressure += weight * pressure;
  for (std::size_t d = 0; d < static_cast<std::size_t>(particles.position.components); ++d) {
    cell.centroid[d] += weight * x[d];
    cell.lower[d] = cell.volume > 0.0 ? std::min(cell.lower[d], x[d] - half[d]) : x[d] - half[d];
    cell.upper[d] = cell.volume > 0.0 ? std::max(cell.upper[d], x[d] + half[d]) : x[d] + half[d];
    cell.mobility[d] += capacity * mobility[d];
  }
  cell.volume += volume;
}

void count_set(const PorousMedium& medium, const Particles& particles, PoreCells& cells) {
  const PermeabilitySpec& rock = medium.flow.rocks[static_cast<std::size_t>(particles.material)];
  const MaterialSpec& material = medium.material_of(particles);
  visit_porous(material, [&](const auto& model) {
    using Model = std::decay_t<decltype(model)>;
    const double per_viscosity = 1.0 / medium.flow.viscosity;
    const double first = initial_pore_point(model).porosity;
    for_each_solid_row(medium.grid, particles, [&](int p, int key) {
      const auto at = MaterialPoint<Model>::read(particles, p);
      const PorePoint point = model.pore_point(at.stress, at.history);
      const double factor =
          per_viscosity * (rock.kozeny_carman ? kozeny_carman(point.porosity, first) : 1.0);
      Vector mobility = rock.permeability;
      for (double& m : mobility) m *= factor;
      const int index = cells.index_of_key[static_cast<std::size_t>(key)];
      const double whole = fluid_volume(material, particles.mass(p), first);
      const double capacity = whole * point.mass_per_volume;
      PoreCell& cell = cells.cells[static_cast<std::size_t>(index)];
      cell.gap += capacity * point.gap;
      cell.gap_pressure = std::max(cell.gap_pressure, point.gap_pressure);
      double storage = point.storage;
      if (storage > 0.0) cell.content += whole * point.fluid_mass;
      if (point.gap > 0.0 && cells.filled[static_cast<std::size_t>(index)])
        storage -= point.gap / point.gap_pressure;
      count_point(particles, p, point.pressure, storage, capacity, mobility, cell);
    });
  });
}

/// From sums to means, and the filled part cut at the faces of the cell.
void finish_cell(const Grid& grid, long long id, PoreCell& cell) {
  if (!(cell.storage > 0.0)) return;
  const std::array<int, 3> place = place_of_cell(grid, id);
  cell.pressure /= cell.storage;
  for (int d = 0; d < grid.patch.dimensions; ++d) {
    const auto axis = static_cast<std::size_t>(d);
    const double begin = grid.lower[d] + place[axis] * grid.cell_size;
    cell.centroid[axis] /= cell.storage;
    cell.mobility[axis] /= cell.volume;
    cell.lower[axis] = std::max(cell.lower[axis], begin);
    cell.upper[axis] = std::min(cell.upper[axis], begin + grid.cell_size);
  }
}

}  // namespace

std::array<int, 3> place_of_cell(const Grid& grid, long long id) {
  const long long x = id % grid.cells[0], rest = id / grid.cells[0];
  return {
      static_cast<int>(x),
      static_cast<int>(rest % grid.cells[1]),
      static_cast<int>(rest / grid.cells[1])};
}

bool fill_pore_cells(const PorousMedium& medium, PoreCells& cells) {
  const Region region("fill_pore_cells");
  std::vector<long long> before;
  std::swap(before, cells.ids);
  const int own_before = cells.own;
  number_cells(medium, cells);
  const bool same =
      cells.own == own_before && std::equal(cells.ids.begin(), cells.ids.end(), before.begin());
  if (same) cells.ids = std::move(before);  // with the others', which the halo still has
  cells.filled.assign(static_cast<std::size_t>(cells.own), 0);
  cells.emptied.assign(static_cast<std::size_t>(cells.own), 0);
  sum_pore_cells(medium, cells);
  return same;
}

void sum_pore_cells(const PorousMedium& medium, PoreCells& cells) {
  cells.cells.assign(static_cast<std::size_t>(cells.own), PoreCell{});
  for (const Particles& particles : medium.particles) count_set(medium, particles, cells);
  for (std::size_t i = 0; i < static_cast<std::size_t>(cells.own); ++i)
    finish_cell(medium.grid, cells.ids[i], cells.cells[i]);
}

}  // namespace barreno
