// SPDX-License-Identifier: BSD-3-Clause
#include "state/body_particles.hpp"

#include "base/numbers.hpp"
#include "scene/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace barreno {
namespace {

/// Even division of an interval into particles of about the wanted size, none wider than a cell.
struct Division {
  double lower = 0.0, size = 0.0;
  long long count = 0;
  double centre(long long i) const { return lower + (static_cast<double>(i) + 0.5) * size; }
};
Division divide(double lower, double upper, double wanted, double cell_size) {
  const double length = upper - lower;
  const auto fewest = static_cast<long long>(std::ceil(length / cell_size - 1e-9));
  const long long n = std::max({1LL, fewest, std::llround(length / wanted)});
  return {lower, (upper - lower) / static_cast<double>(n), n};
}

NewParticle make(
    const GridSpec& grid, const Division& x, const Division& y, long long i, long long j
) {
  NewParticle p;
  p.x = x.centre(i);
  p.y = y.centre(j);
  p.half_x = 0.5 * x.size;
  p.half_y = 0.5 * y.size;
  p.volume = x.size * y.size * (grid.mode == Mode::axisymmetric ? two_pi * p.x : 1.0);
  if (i == 0) p.loaded_sides |= 1U << static_cast<unsigned>(Face::x_lower);
  if (i == x.count - 1) p.loaded_sides |= 1U << static_cast<unsigned>(Face::x_upper);
  if (j == 0) p.loaded_sides |= 1U << static_cast<unsigned>(Face::y_lower);
  if (j == y.count - 1) p.loaded_sides |= 1U << static_cast<unsigned>(Face::y_upper);
  return p;
}

struct Divisions {
  Division x, y;
};

double wanted_size(const GridSpec& grid, const BodySpec& body) {
  return grid.cell_size / body.particles_per_cell;
}

Divisions divide_box(const GridSpec& grid, const BodySpec& body, const Box& box) {
  const double wanted = wanted_size(grid, body);
  return {
      divide(box.lower[0], box.upper[0], wanted, grid.cell_size),
      divide(box.lower[1], box.upper[1], wanted, grid.cell_size)};
}

/// The particle of a piece in its square of the lattice. It stays a box of the whole square, at the
/// centroid of what it holds: a smaller one would cost time steps. A ring has its volume exactly,
/// 2 pi x * area (Pappus).
NewParticle particle_of(const GridSpec& grid, double size, const Piece& piece) {
  NewParticle p;
  p.x = piece.centroid[0];
  p.y = piece.centroid[1];
  p.half_x = p.half_y = 0.5 * size;
  p.volume = piece.measure * (grid.mode == Mode::axisymmetric ? two_pi * p.x : 1.0);
  return p;
}

/// Length of a slug at the material's own density.
double solid_length(const Scene& scene, const JetSlug& slug) {
  const double density =
      scene.materials[static_cast<std::size_t>(scene.jet.material)].material.density;
  return slug.length * slug.density / density;
}

Divisions divide_slug(const Scene& scene, const JetSlug& slug) {
  const double wanted = scene.grid.cell_size / scene.jet.particles_per_cell;
  const bool half = scene.grid.mode == Mode::axisymmetric || scene.grid.lower[0] >= 0.0;
  const double length = solid_length(scene, slug);
  const double h = scene.grid.cell_size;
  return {
      divide(half ? 0.0 : -slug.radius, slug.radius, wanted, h),
      divide(-0.5 * length, 0.5 * length, wanted, h)};
}

void for_each_particle(
    const GridSpec& grid,
    const Divisions& divisions,
    ParticleId first,
    const std::function<void(const NewParticle&)>& visit
) {
  ParticleId id = first;
  for (long long j = 0; j < divisions.y.count; ++j)
    for (long long i = 0; i < divisions.x.count; ++i) {
      NewParticle p = make(grid, divisions.x, divisions.y, i, j);
      p.id = id++;
      visit(p);
    }
}

}  // namespace

void for_each_body_particle(
    const GridSpec& grid,
    const BodySpec& body,
    ParticleId first,
    const std::function<void(const NewParticle&)>& visit
) {
  if (const auto* box = std::get_if<Box>(&body.shape)) {
    for_each_particle(grid, divide_box(grid, body, *box), first, visit);
    return;
  }
  ParticleId id = first;
  const double size = wanted_size(grid, body);
  const auto take = [&](const std::array<long long, 3>& /*cell*/, const Piece& piece) {
    NewParticle p = particle_of(grid, size, piece);
    p.id = id++;
    visit(p);
  };
  for_each_lattice_piece(
      body.shape, dimensions(grid.mode), lattice_of(body.shape, grid, size), take
  );
}

long long count_body_particles(const GridSpec& grid, const BodySpec& body) {
  if (const auto* box = std::get_if<Box>(&body.shape)) {
    const Divisions divisions = divide_box(grid, body, *box);
    return divisions.x.count * divisions.y.count;
  }
  long long count = 0;
  for_each_body_particle(grid, body, 0, [&](const NewParticle&) { ++count; });
  return count;
}

void for_each_slug_particle(
    const Scene& scene,
    const JetSlug& slug,
    ParticleId first,
    const std::function<void(const NewParticle&)>& visit
) {
  for_each_particle(scene.grid, divide_slug(scene, slug), first, visit);
}

long long count_slug_particles(const Scene& scene, const JetSlug& slug) {
  const Divisions divisions = divide_slug(scene, slug);
  return divisions.x.count * divisions.y.count;
}

std::vector<ParticleId> first_ids(const Scene& scene) {
  std::vector<ParticleId> first{1};
  for (const BodySpec& body : scene.bodies)
    first.push_back(first.back() + count_body_particles(scene.grid, body));
  for (const JetSlug& slug : scene.jet.slugs)
    first.push_back(first.back() + count_slug_particles(scene, slug));
  return first;
}

std::vector<SlotRange> all_slots(const Scene& scene) {
  const std::vector<ParticleId> first = first_ids(scene);
  std::vector<SlotRange> slots;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    slots.push_back({scene.bodies[b].material, first[b], first[b + 1] - first[b]});
  if (scene.jet.present) {
    const ParticleId begin = first[scene.bodies.size()];
    slots.push_back({scene.jet.material, begin, first.back() - begin});
  }
  return slots;
}

double smallest_half_size(const Scene& scene, int material) {
  double smallest = 1.0;
  const auto take = [&](const Divisions& d) {
    smallest = std::min(
        {smallest, 0.5 * d.x.size / scene.grid.cell_size, 0.5 * d.y.size / scene.grid.cell_size}
    );
  };
  for (const BodySpec& body : scene.bodies) {
    if (body.material != material) continue;
    if (const auto* box = std::get_if<Box>(&body.shape))
      take(divide_box(scene.grid, body, *box));
    else
      smallest = std::min(smallest, 0.5 / body.particles_per_cell);
  }
  if (scene.jet.present && scene.jet.material == material)
    for (const JetSlug& slug : scene.jet.slugs) take(divide_slug(scene, slug));
  return smallest;
}

}  // namespace barreno
