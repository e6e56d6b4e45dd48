// SPDX-License-Identifier: BSD-3-Clause
#include "step/subcycle/plan_subcycles.hpp"

#include "base/gather.hpp"
#include "base/launch.hpp"
#include "base/region.hpp"
#include "grid/halo.hpp"
#include "state/nodes.hpp"
#include "step/cell_step.hpp"
#include "step/subcycle/count_rows.hpp"
#include "step/subcycle/reached_tiles.hpp"
#include "step/subcycle/stray_rule.hpp"
#include "step/subcycle/tile_exits.hpp"

#include <array>
#include <cmath>

namespace barreno {
namespace {

/// How far beyond its path at its present speed a particle is looked for: it may be accelerated.
constexpr double path_margin = 1.25;

/// Periods of tiles, and where their particles may go before the step is over.
struct TileReach {
  Patch patch;
  BoxTiles box;
  ArrayView<TileFrame> frame;
  ArrayView<unsigned char> level_of_tile;
  TileDirectory directory;
  ArrayView<int> neighbours, parent, period;
  ArrayView<int> entrants;  ///< by own tile: the least period of tiles whose particles may come in
  ArrayView<double> told;
  bool remembers;  ///< what Dormancy knows is of these tiles

  TileReach(const Grid& grid, const Dormancy& dormancy, const Subcycling& subcycling)
      : patch(grid.patch),
        box(grid.box),
        frame(grid.tile_frame),
        level_of_tile(grid.level_of_tile),
        directory(grid.directory),
        neighbours(grid.neighbours),
        parent(grid.parent),
        period(subcycling.period),
        entrants(subcycling.entrants),
        told(subcycling.reach),
        remembers(dormancy.activation == grid.activations) {}

  KOKKOS_INLINE_FUNCTION unsigned exits(int tile) const { return exits_of_tile(told, tile); }
  KOKKOS_INLINE_FUNCTION void tell(int tile, unsigned exits) const {
    told(tile * told_of_tile + told_period) = period(tile);
    told(tile * told_of_tile + told_exits) = exits;
  }
  /// Where a tile's particles may leave towards larger cells its parent tells the tiles there.
  KOKKOS_INLINE_FUNCTION unsigned exits_of_parent(int tile) const {
    const TilePosition at = frame(tile).position;
    const TilePosition coarser = box.parent(at);
    const unsigned own = exits(tile);
    unsigned out = 0;
    const int deep = patch.dimensions == 3 ? 1 : 0;
    for (int z = -deep; z <= deep; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
          if ((own >> direction(x, y, z) & 1U) == 0) continue;
          const TilePosition beside{{at[0] + x, at[1] + y, at[2] + z}, at.level};
          if (!box.has(beside) || level_of_tile(box.box_tile(beside)) >= at.level) continue;
          const TilePosition there = box.parent(beside);
          out |=
              1U << direction(there[0] - coarser[0], there[1] - coarser[1], there[2] - coarser[2]);
        }
    return out;
  }
};

/// The longest period, a power of two, of parts that together are no longer than a step.
KOKKOS_INLINE_FUNCTION int period_within(double step, double part, int most) {
  int period = most;
  while (period > 1 && period * part > step) period /= 2;
  return period;
}

/// A dormant tile's particles have not changed since their stable step was found, and none leaves.
/// @pre entrants counts the rows
KOKKOS_INLINE_FUNCTION bool is_known(const TileReach& reach, const Dormancy& dormancy, int tile) {
  return reach.remembers && dormancy.summed_rows(tile) > 0 &&
         dormancy.summed_rows(tile) == reach.entrants(tile);
}

/// Rows of one set: the longest period that each tile bears, and where they may leave it.
struct FindTileSteps {
  TileReach reach;
  StableStepRule rule;
  Particles particles;
  Dormancy dormancy;
  StrayRule stray;
  double part, step;  ///< of a part, of all parts [time]
  bool by_cells;
  CellStepRule cells;

  KOKKOS_INLINE_FUNCTION unsigned exits_of(int p, const TileFrame& of) const {
    int way[3] = {};
    bool leaves = false;
    for (int d = 0; d < reach.patch.dimensions; ++d) {
      const double path = path_margin * step * particles.velocity(p, d);
      const double to = stray.cells_along(d, p, of) + path / of.cell_size;
      leaves = leaves || stray.side_of(to, d, p, of) != 0;
      way[d] = to < 0.0 ? -1 : to < stray.tile_cells ? 0 : 1;
    }
    if (!leaves) return 0;
    unsigned out = 0;
    for (int k = 1; k < 8; ++k) {
      const int x = (k & 1) != 0 ? way[0] : 0;
      const int y = (k & 2) != 0 ? way[1] : 0;
      const int z = (k & 4) != 0 ? way[2] : 0;
      out |= 1U << direction(x, y, z);
    }
    return out & ~(1U << direction(0, 0, 0));
  }

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    if (is_known(reach, dormancy, tile)) return;
    const TileFrame& of = reach.frame(tile);
    double least = reach.period(tile) * part;
    if (by_cells) {
      const double of_cells = cells.of_tile(tile, of.cell_size);
      least = of_cells < least ? of_cells : least;
    }
    unsigned exits = reach.exits(tile);
    for (int k = particles.tile_begin(tile); k < particles.tile_begin(tile + 1); ++k) {
      const int p = particles.order(k);
      double square = 0.0;
      for (int d = 0; d < particles.velocity.components; ++d)
        square += particles.velocity(p, d) * particles.velocity(p, d);
      if (square > 0.0) exits |= exits_of(p, of);
      if (by_cells || (particles.body(p) & debris_bit) != 0) continue;
      const double density = particles.mass(p) / particles.volume(p);
      const double h = of.cell_size;
      const double rate = rule.compression(h, density, particles.viscous_pressure(p));
      const double stable =
          rule.stable_step(h, density, particles.longitudinal_modulus(p), rate, std::sqrt(square));
      least = stable < least ? stable : least;
    }
    reach.period(tile) = period_within(least, part, reach.period(tile));
    reach.tell(tile, exits);
  }
};

/// Every tile starts with the longest period, a dormant one with what its particles bear.
void start_periods(
    const Grid& grid,
    const std::vector<Particles>& sets,
    const Dormancy& dormancy,
    double part,
    int parts,
    const TileReach& reach
) {
  const ArrayView<int> rows = reach.entrants;
  count_rows(grid, sets, rows);
  launch(
      "start_periods",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile) {
        const bool known = is_known(reach, dormancy, tile);
        reach.period(tile) = known ? period_within(dormancy.step(tile), part, parts) : parts;
        reach.tell(tile, 0);
      }
  );
}

void make_rooms(const Grid& grid, Subcycling& subcycling) {
  if (subcycling.activation == grid.activations) return;
  subcycling.activation = grid.activations;
  const int tiles = grid.active + grid.ghosts;
  if (subcycling.period.extent(0) >= static_cast<std::size_t>(tiles)) return;
  const int with_spare = tiles + tiles / 4;
  const auto room = static_cast<std::size_t>(with_spare);
  const std::size_t nodes = first_motion(grid.patch, with_spare);
  subcycling.period = ArrayView<int>("period", room);
  subcycling.entrants = ArrayView<int>("entrants", room);
  subcycling.node_period =
      ArrayView<unsigned char>("node_period", room * static_cast<std::size_t>(grid.patch.size));
  subcycling.node_periods = ArrayView<unsigned char>("node_periods", room);
  subcycling.ends = ArrayView<unsigned char>("ends", room);
  subcycling.solved = ArrayView<unsigned char>("solved", room);
  subcycling.gained = ArrayView<unsigned char>("gained", room);
  subcycling.reach = ArrayView<double>("reach", told_of_tile * room);
  subcycling.gain = ArrayView<double>("gain", nodes);
  subcycling.whole = ArrayView<double>("whole", nodes);
}

/// Coarser tiles, which have no particles of their own, move with the fastest of those in them.
struct AskFinerTiles {
  TileReach reach;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    const TilePosition at = reach.frame(tile).position;
    int period = reach.period(tile);
    unsigned exits = reach.exits(tile);
    const int layers = reach.patch.dimensions == 3 ? 2 : 1;
    for (int z = 0; z < layers; ++z)
      for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x) {
          const TilePosition finer{
              {2 * at[0] + x, 2 * at[1] + y, layers * at[2] + z}, at.level + 1};
          const int other = reach.directory(reach.box.id(finer));
          if (other < 0) continue;
          period = reach.period(other) < period ? reach.period(other) : period;
          exits |= reach.exits_of_parent(other);
        }
    reach.period(tile) = period;
    reach.tell(tile, exits);
  }
};

void ask_finer_tiles(const Grid& grid, const TileReach& reach) {
  for (int level = grid.box.levels - 2; level >= 0; --level)
    launch(
        "ask_finer_tiles",
        RowPolicy(grid.first_of_level[level], grid.first_of_level[level + 1]),
        AskFinerTiles{reach}
    );
}

/// The least period of particles that may come into each tile from beside it.
void find_entrants(const Grid& grid, const TileReach& reach) {
  launch(
      "find_entrants",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile) {
        int least = reach.period(tile);
        for_each_neighbour(reach.patch, [&](int k, int x, int y, int z) {
          if (x * x > 1 || y * y > 1 || z * z > 1) return;
          const int other = reach.neighbours(tile * reach.patch.neighbours + k);
          if (other < 0 || other == tile) return;
          if ((reach.exits(other) >> back(direction(x, y, z)) & 1U) == 0) return;
          const int period = static_cast<int>(reach.told(other * told_of_tile + told_period));
          least = period < least ? period : least;
        });
        reach.entrants(tile) = least;
      }
  );
  for (int level = 1; level < grid.box.levels; ++level)
    launch(
        "pass_entrants_on",
        RowPolicy(grid.first_of_level[level], grid.first_of_level[level + 1]),
        KOKKOS_LAMBDA(const int tile) {
          // A parent's own period is that of its fastest tile, which others need not follow.
          const int parent = reach.parent(tile);
          const int entrants = reach.entrants(parent);
          if (entrants < reach.period(parent) && entrants < reach.entrants(tile))
            reach.entrants(tile) = entrants;
        }
    );
}

/// @return whether a period has become shorter
bool take_entrants(const Grid& grid, const TileReach& reach) {
  int shorter = 0;
  launch_reduction(
      "take_entrants",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile, int& sum) {
        if (reach.entrants(tile) >= reach.period(tile)) return;
        reach.period(tile) = reach.entrants(tile);
        reach.told(tile * told_of_tile + told_period) = reach.entrants(tile);
        ++sum;
      },
      shorter
  );
  return shorter > 0;
}

/// As many parts as fit, a power of two.
int parts_in(double time, double dt, int most) {
  int parts = 1;
  while (2 * parts <= most && 2 * parts * dt <= time) parts *= 2;
  return parts;
}

}  // namespace

bool plan_subcycles(
    const StepSpec& step,
    const Grid& grid,
    const std::vector<Particles>& sets,
    const Dormancy& dormancy,
    double dt,
    double time_left,
    Subcycling& subcycling
) {
  subcycling.part = 0;
  subcycling.ends_all = false;
  subcycling.parts = parts_in(time_left, dt, subcycling.most);
  if (!subcycling.on()) return false;
  subcycling.length = dt;
  const Region region("plan_subcycles");
  make_rooms(grid, subcycling);
  const TileReach reach(grid, dormancy, subcycling);
  const int parts = subcycling.parts;
  start_periods(grid, sets, dormancy, dt, parts, reach);
  for (const Particles& particles : sets) {
    const StableStepRule rule(
        step, grid.mode, particles.critical_courant, particles.isolated_courant
    );
    launch(
        "find_tile_steps",
        range(grid.active),
        FindTileSteps{
            reach,
            rule,
            particles,
            dormancy,
            StrayRule(grid, particles),
            dt,
            parts * dt,
            decides_by_cells(particles),
            CellStepRule(step, grid.mode, particles)}
    );
  }
  const double reached = count_reached_tiles(grid, subcycling);
  std::array<double, 2> found{1.0, 0.0};  // a period is shorter; tiles are not active yet
  while (found[0] > 0.0) {
    ask_finer_tiles(grid, reach);
    exchange_tiles(grid, reach.told, told_of_tile);
    find_entrants(grid, reach);
    found = {take_entrants(grid, reach) ? 1.0 : 0.0, reached};
    max_over_ranks(*grid.comm, found);
    if (found[1] > 0.0) return true;
  }
  launch(
      "periods_of_ghosts",
      RowPolicy(grid.active, grid.active + grid.ghosts),
      KOKKOS_LAMBDA(const int tile) {
        reach.period(tile) = static_cast<int>(reach.told(tile * told_of_tile + told_period));
      }
  );
  return false;
}

}  // namespace barreno
