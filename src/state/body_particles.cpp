// SPDX-License-Identifier: BSD-3-Clause
#include "state/body_particles.hpp"

#include "base/numbers.hpp"
#include "scene/geometry.hpp"
#include "state/ball_piece.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

namespace barreno {
namespace {

/// Even division of an interval into particles of about the wanted size, none wider than a cell.
struct Division {
  double lower = 0.0, size = 0.0;
  long long count = 1;
  double centre(long long i) const { return lower + (static_cast<double>(i) + 0.5) * size; }
};
Division divide(double lower, double upper, double wanted, double cell_size) {
  const double length = upper - lower;
  const auto fewest = static_cast<long long>(std::ceil(length / cell_size - 1e-9));
  const long long n = std::max({1LL, fewest, std::llround(length / wanted)});
  return {lower, (upper - lower) / static_cast<double>(n), n};
}

/// Particles of a body or a slug: one division per axis, and what is filled if not all is.
struct Divisions {
  Division along[3];
  const Ball* ball = nullptr;  ///< of the x-y plane, filled only inside it
  double radius = 0.0;         ///< of a slug round the y axis, filled only inside it; 0: all
};

using Index = std::array<long long, 3>;

NewParticle make(const GridSpec& grid, const Divisions& divisions, const Index& index) {
  NewParticle p;
  p.volume = 1.0;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(grid.mode)); ++d) {
    const Division& division = divisions.along[d];
    p.x[d] = division.centre(index[d]);
    p.half[d] = 0.5 * division.size;
    p.volume *= division.size;
    if (index[d] == 0) p.loaded_sides |= 1U << (2 * d);
    if (index[d] == division.count - 1) p.loaded_sides |= 1U << (2 * d + 1);
  }
  if (grid.mode == Mode::axisymmetric) p.volume *= two_pi * p.x[0];
  return p;
}

/// Squares of the grid's own lattice that cover [lower, upper] along an axis, so that particles sit
/// in their cells alike everywhere. A millionth of a particle is round-off of the deck's numbers.
Division on_lattice(
    const GridSpec& grid, std::size_t axis, double lower, double upper, double size
) {
  const double from = (lower - grid.lower[axis]) / size;
  const double to = (upper - grid.lower[axis]) / size;
  const auto first = static_cast<long long>(std::floor(from + 1e-6));
  const auto last = static_cast<long long>(std::ceil(to - 1e-6));
  return {grid.lower[axis] + static_cast<double>(first) * size, size, last - first};
}

Divisions divide_body(const GridSpec& grid, const BodySpec& body) {
  const double wanted = grid.cell_size / body.particles_per_cell;
  Divisions divisions;
  const auto* box = std::get_if<Box>(&body.shape);
  if (box == nullptr) divisions.ball = &std::get<Ball>(body.shape);
  const Box around = box_around(body.shape, grid);
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(grid.mode)); ++d)
    divisions.along[d] = box != nullptr
                             ? divide(box->lower[d], box->upper[d], wanted, grid.cell_size)
                             : on_lattice(grid, d, around.lower[d], around.upper[d], wanted);
  return divisions;
}

/// What a ball of the plane of two axes fills of one square.
Piece piece_in_plane(
    const Ball& ball, const Division& a, const Division& b, long long i, long long j
) {
  return ball_particle(ball, {{a.lower, b.lower}, a.size, {a.count, b.count}}, i, j);
}

/// The particle of one square of a lattice that is filled in part; false if there is none. It stays
/// a box of the whole square, at the centroid of what it holds: a smaller one would cost time
/// steps.
bool fill(const GridSpec& grid, const Divisions& divisions, const Index& index, NewParticle& p) {
  const Division& x = divisions.along[0];
  if (divisions.ball != nullptr) {
    const Division& y = divisions.along[1];
    const Piece piece = piece_in_plane(*divisions.ball, x, y, index[0], index[1]);
    if (!(piece.area > 0.0)) return false;
    p.x = {piece.x, piece.y, 0.0};
    p.volume = piece.area * (grid.mode == Mode::axisymmetric ? two_pi * piece.x : 1.0);
  }
  if (divisions.radius > 0.0) {
    const Ball disk{{}, divisions.radius};
    const Piece piece = piece_in_plane(disk, x, divisions.along[2], index[0], index[2]);
    if (!(piece.area > 0.0)) return false;
    p.x = {piece.x, p.x[1], piece.y};
    p.volume = piece.area * divisions.along[1].size;
  }
  p.loaded_sides = 0;
  return true;
}

/// Length of a slug at the material's own density.
double solid_length(const Scene& scene, const JetSlug& slug) {
  const double density =
      scene.materials[static_cast<std::size_t>(scene.jet.material)].material.density;
  return slug.length * slug.density / density;
}

Divisions divide_slug(const Scene& scene, const JetSlug& slug) {
  const GridSpec& grid = scene.grid;
  const double wanted = grid.cell_size / scene.jet.particles_per_cell;
  const double length = solid_length(scene, slug);
  Divisions divisions;
  divisions.along[1] = divide(-0.5 * length, 0.5 * length, wanted, grid.cell_size);
  const auto first = [&](std::size_t axis) { return grid.lower[axis] < 0.0 ? -slug.radius : 0.0; };
  if (grid.mode != Mode::three_dimensional) {
    divisions.along[0] = divide(first(0), slug.radius, wanted, grid.cell_size);
    return divisions;
  }
  divisions.radius = slug.radius;
  for (const std::size_t axis : {0U, 2U})
    divisions.along[axis] = on_lattice(grid, axis, first(axis), slug.radius, wanted);
  return divisions;
}

bool is_filled_in_part(const Divisions& divisions) {
  return divisions.ball != nullptr || divisions.radius > 0.0;
}

void for_each_particle(
    const GridSpec& grid,
    const Divisions& divisions,
    ParticleId first,
    const std::function<void(const NewParticle&)>& visit
) {
  ParticleId id = first;
  Index i{};
  for (i[2] = 0; i[2] < divisions.along[2].count; ++i[2])
    for (i[1] = 0; i[1] < divisions.along[1].count; ++i[1])
      for (i[0] = 0; i[0] < divisions.along[0].count; ++i[0]) {
        NewParticle p = make(grid, divisions, i);
        if (is_filled_in_part(divisions) && !fill(grid, divisions, i, p)) continue;
        p.id = id++;
        visit(p);
      }
}

long long count_particles(const GridSpec& grid, const Divisions& divisions) {
  const auto& along = divisions.along;
  if (!is_filled_in_part(divisions)) return along[0].count * along[1].count * along[2].count;
  long long count = 0;
  for_each_particle(grid, divisions, 0, [&](const NewParticle&) { ++count; });
  return count;
}

}  // namespace

void for_each_body_particle(
    const GridSpec& grid,
    const BodySpec& body,
    ParticleId first,
    const std::function<void(const NewParticle&)>& visit
) {
  for_each_particle(grid, divide_body(grid, body), first, visit);
}

long long count_body_particles(const GridSpec& grid, const BodySpec& body) {
  return count_particles(grid, divide_body(grid, body));
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
  return count_particles(scene.grid, divide_slug(scene, slug));
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
    for (int axis = 0; axis < dimensions(scene.grid.mode); ++axis)
      smallest = std::min(smallest, 0.5 * d.along[axis].size / scene.grid.cell_size);
  };
  for (const BodySpec& body : scene.bodies)
    if (body.material == material) take(divide_body(scene.grid, body));
  if (scene.jet.present && scene.jet.material == material)
    for (const JetSlug& slug : scene.jet.slugs) take(divide_slug(scene, slug));
  return smallest;
}

double largest_corner(const Scene& scene) {
  double largest = 0.0;
  const auto take = [&](const Divisions& d) {
    double sum = 0.0;
    for (int axis = 0; axis < dimensions(scene.grid.mode); ++axis)
      sum += d.along[axis].size * d.along[axis].size;
    largest = std::max(largest, 0.5 * std::sqrt(sum) / scene.grid.cell_size);
  };
  for (const BodySpec& body : scene.bodies) take(divide_body(scene.grid, body));
  for (const JetSlug& slug : scene.jet.slugs) take(divide_slug(scene, slug));
  return largest;
}

}  // namespace barreno
