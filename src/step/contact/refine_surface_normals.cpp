// SPDX-License-Identifier: BSD-3-Clause
#include "step/contact/refine_surface_normals.hpp"

#include "base/launch.hpp"
#include "base/numbers.hpp"
#include "base/region.hpp"
#include "grid/halo.hpp"
#include "shape/visit_kernels.hpp"
#include "step/contact/directions.hpp"
#include "step/contact/particles_at_nodes.hpp"
#include "step/nodes/node_copies.hpp"

#include <limits>

namespace barreno {
namespace {

/// Spreads of the rounds; the last leaves the directions 0.6 degrees apart.
constexpr double spreads[] = {40.0 / 360.0 * two_pi, 10.0 / 360.0 * two_pi, 2.5 / 360.0 * two_pi};
/// By how much another direction must be better [smallest cells of the grid].
constexpr double margin = 1e-3;

template <class M, class S>
struct FindReach {
  static constexpr unsigned extent = M::dimensions;
  static constexpr int dimensions = M::dimensions;
  static constexpr int count = Directions<extent>::count;
  Patch patch;
  NodeCopies copies;
  Directions<extent> directions;
  ParticlesAtNodes<M, S> particles;
  bool second;  ///< the set belongs to the pair's second field
  ArrayView<unsigned char> shared_tile, fields;
  ArrayView<double> normal, reach;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    if (shared_tile(tile) == 0) return;
    constexpr int normals = normal_components(dimensions);
    const double* const n = &normal(first_value(patch, tile, normals));
    double* const out = &reach(first_value(patch, tile, 2 * count));
    particles.for_each(tile, [&](const ParticleEllipse<extent>& ellipse, int slot, double /*s*/) {
      if (fields(tile * patch.size + slot) != 0)
        extend(ellipse, slot, n + slot * normals, out + slot * 2 * count);
    });
  }
  KOKKOS_INLINE_FUNCTION void extend(
      const ParticleEllipse<extent>& ellipse, int slot, const double* n, double* out
  ) const {
    int at[3];
    copies.position(slot, at);
    for (int k = 0; k < count; ++k, out += 2) {
      double direction[extent];
      directions.find(n, k, direction);
      double along = 0.0;
      for (int d = 0; d < dimensions; ++d) along += (ellipse.x[d] - at[d]) * direction[d];
      const double own = ellipse.reach(direction);
      if (second)
        out[1] = std::fmin(out[1], along - own);
      else
        out[0] = std::fmax(out[0], along + own);
    }
  }
};

template <unsigned D>
struct ChooseNormals {
  static constexpr int dimensions = D;
  static constexpr int count = Directions<D>::count;
  NodeCopies copies;
  ArrayView<TileFrame> tile_frame;
  double smallest_cell;
  SymmetryPlanes planes;
  Directions<D> directions;
  unsigned bits;  ///< of both fields
  ArrayView<unsigned char> shared_tile, fields;
  ArrayView<double> normal, reach;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    if (shared_tile(tile) == 0) return;
    constexpr int normals = normal_components(dimensions);
    const Patch& patch = copies.patch;
    double* const n = &normal(first_value(patch, tile, normals));
    for (int slot = 0; slot < patch.size; ++slot)
      if ((fields(tile * patch.size + slot) & bits) == bits) choose(tile, slot, n + slot * normals);
  }

  /// At a symmetry plane the fitted normal is final: it lies in the plane or across it.
  KOKKOS_INLINE_FUNCTION bool mirrored(int tile, int slot) const {
    int at[3];
    copies.position(slot, at);
    bool found = false;
    for (int d = 0; d < dimensions; ++d)
      found = found || planes.holds(d, copies.patch, tile_frame(tile).position, at[d]);
    return found;
  }

  KOKKOS_INLINE_FUNCTION void choose(int tile, int slot, double* n) const {
    double best = gap(tile, slot, 0);
    const double enough = best + margin * (smallest_cell / tile_frame(tile).cell_size);
    int chosen = 0;
    for (int k = 1; k < (mirrored(tile, slot) ? 1 : count); ++k) {
      const double other = gap(tile, slot, k);
      if (!(other > enough) || !(other > best)) continue;
      best = other;
      chosen = k;
    }
    double direction[D];
    directions.find(n, chosen, direction);
    for (int d = 0; d < dimensions; ++d) n[d] = direction[d];
    n[dimensions] = best;
  }

  KOKKOS_INLINE_FUNCTION double gap(int tile, int slot, int k) const {
    double top = -std::numeric_limits<double>::max();
    double bottom = std::numeric_limits<double>::max();
    copies.for_each(tile, slot, [&](int other, int there) {
      const double* const at =
          &reach(first_value(copies.patch, other, 2 * count)) + (there * count + k) * 2;
      top = std::fmax(top, at[0]);
      bottom = std::fmin(bottom, at[1]);
    });
    return bottom - top;
  }
};

void clear_reach(const Grid& grid, const ContactNodes& contact, const ArrayView<double>& reach) {
  const Patch patch = grid.patch;
  const int count = 2 * directions_about(patch.dimensions);
  const auto shared_tile = contact.shared_tile;
  constexpr double far = std::numeric_limits<double>::max();
  launch(
      "clear_reach",
      range(grid.active),
      KOKKOS_LAMBDA(const int tile) {
        if (shared_tile(tile) == 0) return;
        double* const values = &reach(first_value(patch, tile, count));
        for (int i = 0; i < patch.size * count; i += 2) {
          values[i] = -far;
          values[i + 1] = far;
        }
      }
  );
}

/// One pair of fields, what of the nodes belongs to it, and the particles of all sets.
struct PairSurfaces {
  const Grid& grid;
  const std::vector<Particles>& sets;
  const SymmetryPlanes& planes;
  const ContactNodes& contact;
  FieldPair pair;
  ArrayView<double> normal, reach;
};

template <class M, class S>
void find_reach(const PairSurfaces& of, const Directions<M::dimensions>& directions) {
  const Grid& grid = of.grid;
  clear_reach(grid, of.contact, of.reach);
  for (const Particles& particles : of.sets) {
    if (particles.field != of.pair.a && particles.field != of.pair.b) continue;
    launch(
        "find_reach",
        range(grid.active),
        FindReach<M, S>{
            grid.patch,
            NodeCopies(grid),
            directions,
            ParticlesAtNodes<M, S>(grid, of.contact.passes_up, particles),
            particles.field == of.pair.b,
            of.contact.shared_tile,
            of.contact.fields,
            of.normal,
            of.reach}
    );
  }
  exchange_halo(grid, of.reach, 2 * directions_about(M::dimensions));
}

template <class M, class S>
void compare_directions(const PairSurfaces& of, double spread, bool axes) {
  const Directions<M::dimensions> directions(spread, axes);
  find_reach<M, S>(of, directions);
  launch(
      "choose_normals",
      range(of.grid.active),
      ChooseNormals<M::dimensions>{
          NodeCopies(of.grid),
          of.grid.tile_frame,
          of.grid.smallest_cell(),
          of.planes,
          directions,
          bits_of(of.pair),
          of.contact.shared_tile,
          of.contact.fields,
          of.normal,
          of.reach}
  );
}

}  // namespace

void refine_surface_normals(
    const Grid& grid,
    const VelocityFields& fields,
    const std::vector<Particles>& sets,
    const SymmetryPlanes& planes,
    const ContactNodes& contact
) {
  if (!has_surfaces(fields)) return;
  const Region region("refine_surface_normals");
  visit_kernels(grid, [&](auto mode, auto shape) {
    for (std::size_t i = 0; i < fields.pairs.size(); ++i) {
      if (fields.pairs[i].kind == ContactKind::bonded) continue;
      const PairSurfaces surfaces{
          grid, sets, planes, contact, fields.pairs[i], contact.normal[i], contact.reach[i]};
      bool first = true;
      for (const double spread : spreads) {
        compare_directions<decltype(mode), decltype(shape)>(surfaces, spread, first);
        first = false;
      }
    }
  });
}

}  // namespace barreno
