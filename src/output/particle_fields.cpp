// SPDX-License-Identifier: BSD-3-Clause
#include "output/particle_fields.hpp"

#include "output/particle_field_table.hpp"
#include "shape/kinematics_3d.hpp"
#include "shape/shape_facts.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

/// The particle's stress in the space frame.
Sym3 stress_of(const HostParticles& particles, int p) {
  const auto& s = particles.stress;
  if (particles.dimensions() == 3) {
    const auto& r = particles.rotation;
    return rotate(
        SpaceRotation{r(p, 0), r(p, 1), r(p, 2), r(p, 3)},
        {s(p, 0), s(p, 1), s(p, 2), s(p, 3), s(p, 4), s(p, 5)}
    );
  }
  const PlaneStress plane = space_stress(
      {s(p, 0), s(p, 1), s(p, 2), s(p, 3)}, plane_stretch(particles.deformation_gradient, p).plane
  );
  return {plane[0], plane[1], plane[2], plane[3], 0.0, 0.0};
}

}  // namespace

PlaneStress space_stress(const PlaneStress& s, const double F[4]) {
  // The polar decomposition of a 2x2 matrix with positive determinant in closed form.
  const double a = F[0] + F[3], b = F[2] - F[1];
  const double length = std::hypot(a, b);
  if (length == 0.0) return s;
  const double cosine = a / length, sine = b / length;
  const double cc = cosine * cosine, ss = sine * sine, cs = cosine * sine;
  return {
      cc * s[0] + ss * s[1] - 2.0 * cs * s[3],
      ss * s[0] + cc * s[1] + 2.0 * cs * s[3],
      s[2],
      cs * (s[0] - s[1]) + (cc - ss) * s[3]};
}

namespace {

/// Tile and level around a point, read on the host; tile -1: outside.
struct HostCell {
  int tile = -1;
  int level = 0;
};
HostCell host_cell_of(const Grid& grid, const Vector& x) {
  const CellLattice lattice(grid);
  const auto along = [&](int d) { return x[static_cast<std::size_t>(d)]; };
  HostCell cell{lattice.cell_of_level(along, 0).tile, 0};
  if (!grid.is_refined()) return cell;
  cell.level = grid.host_level_of_tile[static_cast<std::size_t>(cell.tile)];
  if (cell.level > 0) cell.tile = lattice.cell_of_level(along, cell.level).tile;
  return cell;
}

}  // namespace

OptionalFields optional_fields(const Scene& scene, const MaterialSpec& material) {
  OptionalFields fields;
  fields.clipped = follows_deformation(scene);
  fields.darcy_velocity = scene.pore_flow.on() && material.is_porous();
  fields.cell_size = !scene.grid.level_of_tile.empty();
  fields.step_length = scene.step.subcycles > 1;
  return fields;
}

CellsAndSteps::CellsAndSteps(
    const OptionalFields& wanted,
    const Grid& grid,
    const std::vector<double>& tile_steps,
    const Particles& particles
) {
  if (!wanted.cell_size && !wanted.step_length) return;
  const double longest =
      tile_steps.empty() ? 0.0 : *std::max_element(tile_steps.begin(), tile_steps.end());
  const auto position = on_host(particles.position.values);
  for (int p = 0; p < particles.count; ++p) {
    // By its position alone: a run that was just resumed has placed no particle yet.
    Vector x{};
    for (int d = 0; d < grid.patch.dimensions; ++d) x[static_cast<std::size_t>(d)] = position(p, d);
    const HostCell cell = grid.holds(x) ? host_cell_of(grid, x) : HostCell{};
    if (wanted.cell_size) cell_size.push_back(grid.cell_size / (1 << cell.level));
    if (!wanted.step_length) continue;
    const double step =
        cell.tile < 0 || tile_steps.empty() ? 0.0 : tile_steps[static_cast<std::size_t>(cell.tile)];
    step_length.push_back(step > 0.0 ? step : longest);
  }
}

void CellsAndSteps::append_cell_size(int p, std::vector<double>& values) const {
  if (!cell_size.empty()) values.push_back(cell_size[static_cast<std::size_t>(p)]);
}
void CellsAndSteps::append_step_length(int p, std::vector<double>& values) const {
  if (!step_length.empty()) values.push_back(step_length[static_cast<std::size_t>(p)]);
}

std::vector<std::string> particle_field_names(
    const MaterialSpec& material, int dimensions, const OptionalFields& optional
) {
  std::vector<std::string> names;
  for (const ParticleField& field : particle_field_table()) {
    if (!field.present(optional)) continue;
    for (const std::string& name : component_names(field, dimensions)) names.push_back(name);
  }
  for (const HistoryField& field : material.history_table()) names.emplace_back(field.name);
  return names;
}

void append_particle_fields(
    const HostParticles& particles,
    int p,
    double reference_density,
    const CellsAndSteps& own,
    std::vector<double>& values
) {
  const ParticleRow row{particles, p, reference_density, own, stress_of(particles, p)};
  for (const ParticleField& field : particle_field_table()) field.read(row, values);
  for (std::size_t c = 0; c < particles.history.extent(1); ++c)
    values.push_back(particles.history(p, c));
}

}  // namespace barreno
