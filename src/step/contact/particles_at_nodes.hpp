// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/coarse_nodes.hpp"
#include "state/shape_fields.hpp"
#include "step/contact/particle_ellipse.hpp"

namespace barreno {

/// The particles of a set that the nodes of a tile get something from: its own, and those of finer
/// tiles in it, whose nodes stand for nodes of the tile (docs/method.md 11). Each tile looks for
/// them, so no two tiles write to one node.
template <class M, class S>
struct ParticlesAtNodes {
  static constexpr unsigned extent = M::dimensions;
  static constexpr int dimensions = M::dimensions;
  PatchFrame<M::dimensions> frame;
  BoxTiles box;
  TileDirectory directory;
  ArrayView<int> parent;
  ArrayView<unsigned char> from_parent;
  ArrayView<unsigned char> passes_up;  ///< ContactNodes::passes_up
  Particles particles;

  ParticlesAtNodes(const Grid& grid, const ArrayView<unsigned char>& passes, const Particles& of)
      : frame(grid),
        box(grid.box),
        directory(grid.directory),
        parent(grid.parent),
        from_parent(grid.from_parent),
        passes_up(passes),
        particles(of) {}

  /// visit(particle in the cells of the tile's patch, slot, weight of the particle at the node)
  template <class Visitor>
  KOKKOS_INLINE_FUNCTION void for_each(int tile, const Visitor& visit) const {
    visit_rows(tile, tile, 0, visit);
    if (box.levels > 1) visit_finer(tile, tile, 0, visit);
  }

private:
  /// @param within  tile that holds the finer ones, `up` levels finer than `tile`
  template <class Visitor>
  KOKKOS_INLINE_FUNCTION void visit_finer(int tile, int within, int up, const Visitor& visit)
      const {
    for_each_finer_tile(box, frame.tile_frame(within).position, [&](const TilePosition& at) {
      const int other = directory(box.id(at));
      if (other < 0 || passes_up(other) == 0) return;
      visit_rows(tile, other, up + 1, visit);
      visit_finer(tile, other, up + 1, visit);
    });
  }

  /// Particles of a tile, `up` levels finer than the one whose nodes are asked for.
  template <class Visitor>
  KOKKOS_INLINE_FUNCTION void visit_rows(int tile, int of, int up, const Visitor& visit) const {
    const auto first = frame.first(of);
    for (int k = particles.tile_begin(of); k < particles.tile_begin(of + 1); ++k) {
      const int p = particles.order(k);
      const ParticleGeometry particle =
          frame.template geometry<S>(first, shape_fields(particles), p);
      ParticleEllipse<extent> ellipse(particle, particles, p);
      if (up > 0) look_from(tile, of, up, ellipse);
      const auto give = [&](int slot, double weight) { visit(ellipse, slot, weight); };
      S::template support<M>(particle).for_each_node(
          frame.patch,
          [&](int slot, double s, const double*, double) {
            if (s > 0.0) climb(of, slot, s, up, give);
          }
      );
    }
  }

  /// From the cells of a finer tile's patch to those of a tile around it.
  KOKKOS_INLINE_FUNCTION void look_from(int tile, int of, int up, ParticleEllipse<extent>& ellipse)
      const {
    const double scale = 1.0 / (1 << up);
    const Patch& patch = frame.patch;
    const TilePosition &fine = frame.tile_frame(of).position,
                       &coarse = frame.tile_frame(tile).position;
    for (int d = 0; d < dimensions; ++d) {
      const int first_fine = fine[d] * patch.tile_cells - patch.reach;
      const int first_coarse = coarse[d] * patch.tile_cells - patch.reach;
      ellipse.x[d] = (ellipse.x[d] + first_fine) * scale - first_coarse;
      for (int i = 0; i < dimensions; ++i) ellipse.axis[i][d] *= scale;
    }
  }

  /// The nodes `up` levels coarser that a node stands for; none if it is an unknown on the way.
  template <class Visitor>
  KOKKOS_INLINE_FUNCTION void climb(int tile, int slot, double weight, int up, const Visitor& visit)
      const {
    if (up == 0) {
      visit(slot, weight);
      return;
    }
    if (from_parent(tile * frame.patch.size + slot) == 0) return;
    for_each_coarse_node(
        frame.patch,
        frame.tile_frame(tile).position,
        slot,
        [&](int coarse, double share) {
          climb(parent(tile), coarse, weight * share, up - 1, visit);
        }
    );
  }
};

}  // namespace barreno
