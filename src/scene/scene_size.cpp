// SPDX-License-Identifier: BSD-3-Clause
#include "base/process.hpp"
#include "deck/section_table.hpp"
#include "scene/build_scene.hpp"
#include "scene/geometry.hpp"
#include "scene/jet.hpp"
#include "scene/scene_parts.hpp"
#include "scene/tile_levels.hpp"
#include "scene/tile_size.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace barreno {
namespace {

/// Cells along an axis, and places for tiles, are numbered in 32 bits.
constexpr double max_count = std::numeric_limits<int>::max();
/// Every rank goes through the levels of all tiles of a refined box.
constexpr double max_refined_tiles = 16777216.0;
/// Ids are written as 64 bits, and read by programs that take them for numbers of double precision.
constexpr double max_particles = 9007199254740992.0;
/// Owner and cost of a parcel of tiles, with what it takes to deal them out.
constexpr double bytes_per_parcel = 128.0;
/// Of what a rank keeps of the whole box: levels of tiles, and where tiles of each level have their
/// page (TileDirectory).
constexpr double bytes_per_refined_tile = 2.0;
constexpr double bytes_per_place = 4.0 / 256.0;
/// State arrays, their share of active tiles and what brings them into a file, of which a run's
/// largest memory consists: 1040 bytes in the plane between perforation_120us.xml with two
/// fidelities, 2140 in space beyond the program, perforation_3d.xml.
constexpr double estimated_particle_bytes(int dimensions) {
  return dimensions == 3 ? 2000.0 : 1000.0;
}

double cells_along(const GridSpec& grid, std::size_t axis) {
  return (grid.upper[axis] - grid.lower[axis]) / grid.cell_size;
}

double tiles_of(const GridSpec& grid) {
  double tiles = 1.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions(grid.mode)); ++i)
    tiles *= std::ceil((grid.upper[i] - grid.lower[i]) / tile_size_of(grid));
  return tiles;
}

/// Where tiles of each level may be in the box.
double places_of(const GridSpec& grid) {
  double places = 0.0;
  for (int level = 0; level <= finest_level(grid); ++level)
    places += tiles_of(grid) * std::pow(2.0, level * dimensions(grid.mode));
  return places;
}

/// What every rank keeps of the whole box.
double box_bytes(const GridSpec& grid) {
  const double tiles = tiles_of(grid);
  return bytes_per_parcel * std::min(tiles, static_cast<double>(grid.most_parcels)) +
         bytes_per_place * places_of(grid) +
         (finest_level(grid) > 0 ? bytes_per_refined_tile * tiles : 0.0);
}

/// Refuses more tiles than can be numbered, or than a box that is refined can have.
void check_tiles(
    const Deck& deck, const GridSpec& grid, double tiles, double most, const std::string& reason
) {
  if (tiles <= most) return;
  const double cells = std::pow(tile_cells, dimensions(grid.mode));
  deck.refuse_value(
      path_of(&GridSpec::cell_size),
      "divides the box into " + text_of("%.3g", tiles * cells) + " cells (at most " +
          text_of("%.3g", most * cells) + reason + "); choose larger cells or a smaller box"
  );
}

/// Of the lattices that are walked through to fill bodies, all but those of boxes: one of a thin
/// body across the grid is far larger than what it holds.
double filling_bytes(const Scene& scene) {
  constexpr double bytes_per_cell = 8.0;
  double cells = 0.0;
  for (const BodySpec& body : scene.bodies) {
    if (std::holds_alternative<Box>(body.shape)) continue;
    const Box around = box_around(body.shape, scene.grid);
    const double size = scene.grid.cell_size / body.particles_per_cell;
    double count = 1.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions(scene.grid.mode)); ++i)
      count *= std::max(0.0, around.upper[i] - around.lower[i]) / size;
    cells = std::max(cells, count);
  }
  return bytes_per_cell * cells;
}

/// Of the cells around the path of a jet, in which its channel is measured.
double channel_bytes(const Scene& scene) {
  if (!scene.jet.present) return 0.0;
  constexpr double bytes_per_cell = 8.0;
  return bytes_per_cell * cells_along(scene.grid, 0) * cells_along(scene.grid, 1);
}

void check_cells(const Deck& deck, const GridSpec& grid) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions(grid.mode)); ++i) {
    const double along = cells_along(grid, i) * std::pow(2.0, finest_level(grid));
    if (!(along <= max_count))
      deck.refuse_value(
          path_of(&GridSpec::cell_size),
          "divides the box into " + text_of("%.3g", along) + " cells along " +
              std::string(1, "xyz"[i]) + " (at most " + text_of("%.3g", max_count) +
              " can be indexed); choose larger cells or a smaller box"
      );
    const double farthest = std::max(std::abs(grid.lower[i]), std::abs(grid.upper[i]));
    constexpr double places_in_cell = 1e6;
    if (farthest * std::numeric_limits<double>::epsilon() * places_in_cell > grid.cell_size)
      deck.refuse_value(
          path_of(&GridSpec::cell_size),
          "is too small for a box that reaches to " + text_of("%.6g", farthest) + " m along " +
              std::string(1, "xyz"[i]) +
              " (double-precision numbers there are hardly finer than the cells); choose larger "
              "cells or move the box to the origin"
      );
  }
}

}  // namespace

double particle_estimate(const Scene& scene) {
  const int d = dimensions(scene.grid.mode);
  double particles = 0.0;
  for (const BodySpec& body : scene.bodies) {
    const double size = scene.grid.cell_size / body.particles_per_cell;
    particles += max_measure(body.shape, scene.grid) / std::pow(size, d) *
                 refined_share(scene.grid, box_around(body.shape, scene.grid));
  }
  for (const JetSlug& slug : scene.jet.slugs) {
    const double per_length =
        scene.jet.particles_per_cell / grid_of_jet(scene.grid, scene.jet).cell_size;
    // A slug thinner than a particle is still one.
    const double across = std::max(1.0, slug.radius * per_length);
    particles +=
        (d == 3 ? 4.0 * across * across : across) * std::max(1.0, slug.length * per_length);
  }
  return particles;
}

double memory_estimate(const Scene& scene) {
  return box_bytes(scene.grid) + channel_bytes(scene) +
         estimated_particle_bytes(dimensions(scene.grid.mode)) * particle_estimate(scene);
}

void check_refined_size(const Deck& deck, const GridSpec& grid) {
  check_tiles(
      deck, grid, tiles_of(grid), max_refined_tiles, " in a box of which a part is refined"
  );
}

void check_size(const Deck& deck, const Scene& scene) {
  check_cells(deck, scene.grid);
  const double bytes = memory_estimate(scene) + filling_bytes(scene);
  const double machine = machine_bytes(), available = machines() * machine;
  const double places = places_of(scene.grid), particles = particle_estimate(scene);
  check_tiles(deck, scene.grid, places, max_count, " can be indexed");
  if (!(particles <= max_particles))
    deck.refuse_value(
        path_of(&GridSpec::cell_size),
        "makes " + text_of("%.3g", particles) +
            " particles (at most 2^53 can be numbered); choose larger cells, fewer Particles Per "
            "Cell or smaller bodies"
    );
  if (bytes <= available) return;
  deck.refuse_value(
      path_of(&GridSpec::cell_size),
      "makes the run too large for memory (grid and particles need " + text_of("%.0f", bytes) +
          " bytes, more than " +
          (machines() == 1 ? "this machine has"
                           : text_of("%.0f", machines()) + " machines like this one have") +
          "); choose larger cells or a smaller box, or ranks on " +
          text_of("%.0f", std::ceil(bytes / machine)) + " machines of this size"
  );
}

}  // namespace barreno
