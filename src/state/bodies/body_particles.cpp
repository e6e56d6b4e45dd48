// SPDX-License-Identifier: BSD-3-Clause
#include "state/bodies/body_particles.hpp"

#include "base/numbers.hpp"
#include "scene/geometry.hpp"
#include "scene/jet.hpp"
#include "scene/tile_levels.hpp"
#include "state/bodies/box_divisions.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace barreno {
namespace {

/// The particle of a piece in its square of the lattice. It stays a box of the whole square, at the
/// centroid of what it holds: a smaller one would cost time steps. A ring has its volume exactly,
/// 2 pi x * area (Pappus).
NewParticle particle_of(const GridSpec& grid, double size, const Piece& piece) {
  NewParticle p;
  p.x = piece.centroid;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(grid.mode)); ++d)
    p.half[d] = 0.5 * size;
  p.volume = piece.measure * (grid.mode == Mode::axisymmetric ? two_pi * p.x[0] : 1.0);
  return p;
}

/// What slugs are cut into: the grid's lattice, the jet's particles per cell, and its material's
/// own density.
struct SlugLattice {
  GridSpec grid;
  const JetSpec& jet;
  double density;

  double size() const { return grid.cell_size / jet.particles_per_cell; }
};
SlugLattice slug_lattice(const Scene& scene) {
  const auto m = static_cast<std::size_t>(scene.jet.material);
  return {grid_of_jet(scene.grid, scene.jet), scene.jet, scene.materials[m].density()};
}

/// Layers of a slug along its axis, which is as long as its mass is at the material's own density,
/// or in a continuous jet as long as it is.
Division divide_length(const SlugLattice& lattice, const JetSlug& slug) {
  const bool whole = traits_of(lattice.jet.kind).expanded;
  const double length = whole ? slug.length : slug.length * slug.density / lattice.density;
  return divide(-0.5 * length, 0.5 * length, lattice.size(), lattice.grid.cell_size);
}

/// Where a slug begins along x or z: a grid that begins at 0 holds a half.
double slug_lower(const GridSpec& grid, const JetSlug& slug, std::size_t axis) {
  return grid.lower[axis] < 0.0 ? -slug.radius : 0.0;
}

/// @pre the mode has two dimensions
Divisions divide_slug(const SlugLattice& lattice, const JetSlug& slug) {
  const double lower = slug_lower(lattice.grid, slug, 0);
  return {
      {divide(lower, slug.radius, lattice.size(), lattice.grid.cell_size),
       divide_length(lattice, slug),
       {}}};
}

/// visit(piece) for what the disk of a round slug fills of the lattice in the plane of x and z.
void for_each_disk_piece(
    const SlugLattice& lattice, const JetSlug& slug, const std::function<void(const Piece&)>& visit
) {
  const GridSpec& grid = lattice.grid;
  const Box around{
      {slug_lower(grid, slug, 0), slug_lower(grid, slug, 2), 0.0}, {slug.radius, slug.radius, 0.0}};
  const Vector origin{grid.lower[0], grid.lower[2], 0.0};
  for_each_lattice_piece(
      Ball{{}, slug.radius},
      2,
      lattice_around(around, origin, lattice.size(), 2),
      [&](const PlaceIndex& /*cell*/, const Piece& piece) { visit(piece); }
  );
}

/// The particle of a disk's piece in one layer of a round slug.
NewParticle round_particle(double size, const Piece& piece, const Division& layers, long long j) {
  NewParticle p;
  p.x = {piece.centroid[0], layers.centre(j), piece.centroid[1]};
  p.half = {0.5 * size, 0.5 * layers.size, 0.5 * size};
  p.volume = piece.measure * layers.size;
  return p;
}

/// visit(particle) for the equal parts of a particle of a lattice, one per particle that its tile's
/// level asks for: 2^level along each axis. They hold its volume and first moments; in axisymmetry
/// a part has the volume of its own ring.
void for_each_part(
    const GridSpec& grid,
    const NewParticle& whole,
    const std::function<void(const NewParticle&)>& visit
) {
  const int level = level_at(grid, whole.x);
  if (level == 0) return visit(whole);
  const int dimension = dimensions(grid.mode);
  const int along = 1 << level;
  const int last = along - 1;
  const PlaceIndex count{along, along, dimension == 3 ? along : 1};
  PlaceIndex i{};
  for (i[2] = 0; i[2] < count[2]; ++i[2])
    for (i[1] = 0; i[1] < count[1]; ++i[1])
      for (i[0] = 0; i[0] < count[0]; ++i[0]) {
        NewParticle part = whole;
        for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d) {
          part.half[d] = whole.half[d] / along;
          part.x[d] = whole.x[d] + static_cast<double>(2 * i[d] - last) * part.half[d];
          part.volume /= along;
          if (i[d] != 0) part.loaded_sides &= ~(1U << (2 * d));
          if (i[d] != last) part.loaded_sides &= ~(1U << (2 * d + 1));
        }
        if (grid.mode == Mode::axisymmetric) part.volume *= part.x[0] / whole.x[0];
        visit(part);
      }
}

void for_each_particle(
    const GridSpec& grid,
    const Divisions& divisions,
    ParticleId first,
    const std::function<void(const NewParticle&)>& visit
) {
  ParticleId id = first;
  PlaceIndex i{};
  for (i[2] = 0; i[2] < divisions.along[2].count; ++i[2])
    for (i[1] = 0; i[1] < divisions.along[1].count; ++i[1])
      for (i[0] = 0; i[0] < divisions.along[0].count; ++i[0]) {
        NewParticle p = particle_at(grid, divisions, i);
        p.id = id++;
        visit(p);
      }
}

}  // namespace

void for_each_body_particle(
    const GridSpec& grid,
    const BodySpec& body,
    ParticleId first,
    const std::function<void(const NewParticle&)>& visit,
    BoxCuts where
) {
  if (const auto* box = std::get_if<Box>(&body.shape)) {
    for_each_box_part(
        grid,
        body,
        *box,
        where,
        [&](const GridSpec& own, const Divisions& divisions, unsigned ends) {
          for_each_particle(own, divisions, first, [&](NewParticle p) {
            p.loaded_sides &= ends;
            visit(p);
          });
          first += count_places(divisions);
        }
    );
    return;
  }
  const Lattice lattice = body_lattice(grid, body);
  for_each_lattice_particle(grid, body, {0, count_cells(lattice)}, first, visit);
}

Lattice body_lattice(const GridSpec& grid, const BodySpec& body) {
  return lattice_of(body.shape, grid, wanted_size(grid, body));
}

void for_each_lattice_particle(
    const GridSpec& grid,
    const BodySpec& body,
    const CellSpan& span,
    ParticleId first,
    const std::function<void(const NewParticle&)>& visit
) {
  ParticleId id = first;
  const Lattice lattice = body_lattice(grid, body);
  const auto take = [&](const PlaceIndex& /*cell*/, const Piece& piece) {
    for_each_part(grid, particle_of(grid, lattice.size, piece), [&](NewParticle p) {
      p.id = id++;
      visit(p);
    });
  };
  for_each_lattice_piece(body.shape, dimensions(grid.mode), lattice, span, take);
}

long long count_body_particles(const GridSpec& grid, const BodySpec& body, BoxCuts where) {
  long long count = 0;
  if (const auto* box = std::get_if<Box>(&body.shape)) {
    const auto add = [&](const GridSpec&, const Divisions& part, unsigned) {
      count += count_places(part);
    };
    for_each_box_part(grid, body, *box, where, add);
    return count;
  }
  for_each_body_particle(grid, body, 0, [&](const NewParticle&) { ++count; });
  return count;
}

void for_each_slug_particle(
    const GridSpec& grid,
    const JetSpec& jet,
    double density,
    const JetSlug& slug,
    ParticleId first,
    const std::function<void(const NewParticle&)>& visit
) {
  const SlugLattice lattice{grid_of_jet(grid, jet), jet, density};
  if (grid.mode != Mode::three_dimensional) {
    for_each_particle(lattice.grid, divide_slug(lattice, slug), first, visit);
    return;
  }
  ParticleId id = first;
  const Division layers = divide_length(lattice, slug);
  for_each_disk_piece(lattice, slug, [&](const Piece& piece) {
    for (long long j = 0; j < layers.count; ++j) {
      NewParticle p = round_particle(lattice.size(), piece, layers, j);
      p.id = id++;
      visit(p);
    }
  });
}

long long count_slug_particles(const Scene& scene, const JetSlug& slug) {
  const SlugLattice lattice = slug_lattice(scene);
  if (scene.grid.mode != Mode::three_dimensional) return count_places(divide_slug(lattice, slug));
  long long pieces = 0;
  for_each_disk_piece(lattice, slug, [&](const Piece&) { ++pieces; });
  return pieces * divide_length(lattice, slug).count;
}

ParticleId ids_of_particle(const Scene& scene, const BodySpec& body) {
  return ParticleId{1} << scene.materials[static_cast<std::size_t>(body.material)].splits();
}

ParticleId ids_of_particle(const JetSpec& jet) {
  return ParticleId{1} << jet.splits;
}

std::vector<ParticleId> first_ids(const Scene& scene, const std::vector<long long>& counts) {
  std::vector<ParticleId> first{1};
  for (std::size_t b = 0; b < counts.size(); ++b)
    first.push_back(
        first.back() + counts[b] * (b < scene.bodies.size()
                                        ? ids_of_particle(scene, scene.bodies[b])
                                        : ids_of_particle(scene.jet))
    );
  return first;
}

std::vector<long long> particle_counts(const Scene& scene) {
  std::vector<long long> counts;
  for (const BodySpec& body : scene.bodies)
    counts.push_back(count_body_particles(scene.grid, body, box_cuts(scene)));
  for (const JetSlug& slug : scene.jet.slugs) counts.push_back(count_slug_particles(scene, slug));
  return counts;
}

std::vector<IdRange> particle_id_ranges(const Scene& scene, const std::vector<ParticleId>& first) {
  std::vector<IdRange> slots;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    slots.push_back({scene.bodies[b].material, first[b], first[b + 1] - first[b]});
  if (scene.jet.present) {
    const ParticleId begin = first[scene.bodies.size()];
    slots.push_back({scene.jet.material, begin, first.back() - begin});
  }
  return slots;
}

double smallest_half_size(const Scene& scene, int material) {
  double h = scene.grid.cell_size;
  double smallest = 1.0;
  const auto take = [&](const Division& d) { smallest = std::min(smallest, 0.5 * d.size / h); };
  for (const BodySpec& body : scene.bodies) {
    if (body.material != material) continue;
    const auto* box = std::get_if<Box>(&body.shape);
    if (box == nullptr) {
      smallest = std::min(smallest, 0.5 / body.particles_per_cell);
      continue;
    }
    for_each_box_part(
        scene.grid,
        body,
        *box,
        box_cuts(scene),
        [&](const GridSpec& own, const Divisions& part, unsigned) {
          h = own.cell_size;
          for (int d = 0; d < dimensions(own.mode); ++d) take(part.along[d]);
        }
    );
  }
  // What is divided becomes so small along one axis.
  smallest /= 1 << scene.materials[static_cast<std::size_t>(material)].splits();
  if (!scene.jet.present || scene.jet.material != material) return smallest;
  const SlugLattice lattice = slug_lattice(scene);
  h = lattice.grid.cell_size;
  for (const JetSlug& slug : scene.jet.slugs) {
    take(divide_length(lattice, slug));
    if (scene.grid.mode == Mode::three_dimensional)
      smallest = std::min(smallest, 0.5 / scene.jet.particles_per_cell);
    else
      take(divide_slug(lattice, slug).along[0]);
  }
  return smallest;
}

double largest_corner(const Scene& scene) {
  const int dimension = dimensions(scene.grid.mode);
  double h = scene.grid.cell_size;
  double largest = 0.0;
  const auto take = [&](double x, double y, double z) {
    if (dimension == 2) z = 0.0;
    largest = std::max(largest, 0.5 * std::sqrt(x * x + y * y + z * z) / h);
  };
  for (const BodySpec& body : scene.bodies) {
    h = scene.grid.cell_size;
    const double size = wanted_size(scene.grid, body);
    if (const auto* box = std::get_if<Box>(&body.shape)) {
      for_each_box_part(
          scene.grid,
          body,
          *box,
          box_cuts(scene),
          [&](const GridSpec& own, const Divisions& d, unsigned) {
            h = own.cell_size;
            take(d.along[0].size, d.along[1].size, d.along[2].size);
          }
      );
    } else {
      take(size, size, size);
    }
  }
  if (!scene.jet.present) return largest;
  const SlugLattice lattice = slug_lattice(scene);
  h = lattice.grid.cell_size;
  for (const JetSlug& slug : scene.jet.slugs) {
    const double across =
        dimension == 2 ? divide_slug(lattice, slug).along[0].size : lattice.size();
    take(across, divide_length(lattice, slug).size, across);
  }
  return largest;
}

}  // namespace barreno
