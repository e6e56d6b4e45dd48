// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/fill.hpp"
#include "scene/scene.hpp"
#include "state/id_ranges.hpp"

#include <functional>

namespace barreno {

/// One particle as it is made: place, size and volume (full circle in axisymmetry).
struct NewParticle {
  ParticleId id = 0;
  Vector x{};
  Vector half{};
  double volume = 0.0;
  unsigned loaded_sides = 0;  ///< bits by Face: the outer layers of a box
  Vector velocity{};          ///< at the start
};

/// Where boxes are cut before they are divided, if cells are of several sizes: at the borders of
/// tiles, and at the lines of cells next to the box's ends too.
enum class BoxCuts { at_tiles, at_cells };

/// CPDI knows faces by their corners. On the two sides of a border between cells of different sizes
/// these give the same forces only if the faces lie within cells. docs/method.md 11
BoxCuts box_cuts(const Scene& scene);

/// Fill a body with particles, in the order of their ids from `first` on.
///
/// A box is divided evenly, so that its mass and its faces are exact; other shapes take the pieces
/// of the grid's regular lattice (cell size / particles per cell) that lie inside
/// (geometry/fill.hpp).
void for_each_body_particle(
    const GridSpec& grid,
    const BodySpec& body,
    ParticleId first,
    const std::function<void(const NewParticle&)>& visit,
    BoxCuts where = BoxCuts::at_tiles
);
long long count_body_particles(
    const GridSpec& grid, const BodySpec& body, BoxCuts where = BoxCuts::at_tiles
);

/// The lattice that a body is cut from which is no box.
Lattice body_lattice(const GridSpec& grid, const BodySpec& body);
/// The particles of a span of its cells, in the order of their ids from `first` on.
void for_each_lattice_particle(
    const GridSpec& grid,
    const BodySpec& body,
    const CellSpan& span,
    ParticleId first,
    const std::function<void(const NewParticle&)>& visit
);

/// Divide a slug of the jet evenly: a slug thinner than a particle becomes one, so that mass,
/// momentum and energy are exact. Density below the material's own shortens a slug, but not
/// in a continuous jet. The slug's centre is at y = 0.
///
/// In plane strain with x = 0 at the lower edge of the grid the half x > 0 is made, else the whole
/// width. In three dimensions a slug is round: pieces of its disk in the squares of the grid's
/// lattice, of which planes x = 0 and z = 0 at lower faces of the grid leave a half or a quarter.
///
/// @param density  of the jet's material at reference [mass/length^3]
void for_each_slug_particle(
    const GridSpec& grid,
    const JetSpec& jet,
    double density,
    const JetSlug& slug,
    ParticleId first,
    const std::function<void(const NewParticle&)>& visit
);
long long count_slug_particles(const Scene& scene, const JetSlug& slug);

/// Ids that a body, or the jet, keeps for every particle that it starts with: one for each part
/// that it may be divided into.
ParticleId ids_of_particle(const Scene& scene, const BodySpec& body);
ParticleId ids_of_particle(const JetSpec& jet);

/// Particles of every body, then of every slug of the jet; one process alone looks at all of them
/// (state/bodies/body_census.hpp has the ranks share that).
std::vector<long long> particle_counts(const Scene& scene);

/// First id of every body, then of every slug of the jet, then one past the last.
/// @param counts  of their particles
std::vector<ParticleId> first_ids(const Scene& scene, const std::vector<long long>& counts);

/// Half size, in cells, of the smallest particle that the scene gives a material.
double smallest_half_size(const Scene& scene, int material);

/// From the centre to a corner, in cells, of the largest particle that the scene gives anything.
double largest_corner(const Scene& scene);

}  // namespace barreno
