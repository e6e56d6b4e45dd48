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

#include <barreno/real.hpp>
#include <limits>

namespace barreno {
namespace {

/// Spreads of the rounds; the last leaves the directions 0.6 degrees apart.
constexpr double spreads[] = {40.0 / 360.0 * two_pi, 10.0 / 360.0 * two_pi, 2.5 / 360.0 * two_pi};
/// By how much another direction must be better [smallest cells of the grid].
constexpr double margin = 1e-3;

/// What particles of one of two fields reach along the directions about the normals of nodes.
template <unsigned D>
struct ReachOfParticle {
  static constexpr int dimensions = D;
  NodeCopies copies;
  Directions<D> directions;
  bool second;  ///< the particle belongs to the second field

  /// Once for all shape functions, which are inlined: compiling it takes long.
  /// @param n    the normal of the node of this slot
  /// @param out  top of the first field and bottom of the second along each direction
  [[gnu::noinline]] KOKKOS_FUNCTION void extend(
      const ParticleEllipse<D>& ellipse, int slot, const double* n, double* out
  ) const {
    int at[3];
    copies.position(slot, at);
    double from_node[D];
    for (int d = 0; d < dimensions; ++d) from_node[d] = ellipse.x[d] - at[d];
    double direction[D][Directions<D>::all];
    double along[Directions<D>::all], own[Directions<D>::all];
    directions.find_all(typename Directions<D>::About(n), direction);
    const int different = directions.different;
    for (int k = 0; k < different; ++k) {
      along[k] = 0.0;
      for (int d = 0; d < dimensions; ++d) along[k] += from_node[d] * direction[d][k];
    }
    ellipse.reach(direction, different, own);
    for (int k = 0; second && k < different; ++k)
      out[2 * k + 1] = real::smaller(along[k] - own[k], out[2 * k + 1]);
    for (int k = 0; !second && k < different; ++k)
      out[2 * k] = real::larger(along[k] + own[k], out[2 * k]);
  }
};

template <class M, class S>
struct FindReach {
  static constexpr unsigned extent = M::dimensions;
  static constexpr int dimensions = M::dimensions;
  static constexpr int count = Directions<extent>::count;
  Patch patch;
  ReachOfParticle<extent> of_particle;
  ParticlesAtNodes<M, S> particles;
  unsigned bits;  ///< of both fields
  ArrayView<unsigned char> shared_tile, fields;
  ArrayView<double> normal, reach;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    if (shared_tile(tile) == 0) return;
    constexpr int normals = normal_components(dimensions);
    const double* const n = &normal(first_value(patch, tile, normals));
    double* const out = &reach(first_value(patch, tile, 2 * count));
    particles.for_each(tile, [&](const ParticleEllipse<extent>& ellipse, int slot, double /*s*/) {
      if ((fields(tile * patch.size + slot) & bits) == bits)
        of_particle.extend(ellipse, slot, n + slot * normals, out + slot * 2 * count);
    });
  }
};

template <unsigned D>
struct ChooseNormals {
  static constexpr int dimensions = D;
  static constexpr int count = Directions<D>::count;
  static constexpr std::size_t all = Directions<D>::all;
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
    const int compared = mirrored(tile, slot) ? 1 : directions.different;
    double gap[all];
    find_gaps(tile, slot, compared, gap);
    double best = gap[0];
    const double enough = best + margin * (smallest_cell / tile_frame(tile).cell_size);
    int chosen = 0;
    for (int k = 1; k < compared; ++k) {
      if (!(gap[k] > enough) || !(gap[k] > best)) continue;
      best = gap[k];
      chosen = k;
    }
    double direction[D];
    directions.find(typename Directions<D>::About(n), chosen, direction);
    for (int d = 0; d < dimensions; ++d) n[d] = direction[d];
    n[dimensions] = best;
  }

  KOKKOS_INLINE_FUNCTION void find_gaps(int tile, int slot, int compared, double (&gap)[all])
      const {
    double top[all], bottom[all];
    for (int k = 0; k < compared; ++k) {
      top[k] = -std::numeric_limits<double>::max();
      bottom[k] = std::numeric_limits<double>::max();
    }
    copies.for_each(tile, slot, [&](int other, int there) {
      const double* const at =
          &reach(first_value(copies.patch, other, 2 * count)) + there * count * 2;
      for (int k = 0; k < compared; ++k) {
        top[k] = real::larger(at[2 * k], top[k]);
        bottom[k] = real::smaller(at[2 * k + 1], bottom[k]);
      }
    });
    for (int k = 0; k < compared; ++k) gap[k] = bottom[k] - top[k];
  }
};

/// One pair of fields, what of the nodes belongs to it, and the particles of all sets.
struct PairSurfaces {
  const Grid& grid;
  const std::vector<Particles>& sets;
  const SymmetryPlanes& planes;
  const ContactNodes& contact;
  FieldPair pair;
  ArrayView<double> normal, reach;
};

/// Of nodes where both fields meet, at which alone it is asked for.
void clear_reach(const PairSurfaces& of) {
  const Patch patch = of.grid.patch;
  const int count = 2 * directions_about(patch.dimensions);
  const unsigned bits = bits_of(of.pair);
  const auto shared_tile = of.contact.shared_tile;
  const auto fields = of.contact.fields;
  const auto reach = of.reach;
  constexpr double far = std::numeric_limits<double>::max();
  launch(
      "clear_reach",
      range(of.grid.active),
      KOKKOS_LAMBDA(const int tile) {
        if (shared_tile(tile) == 0) return;
        double* values = &reach(first_value(patch, tile, count));
        for (int slot = 0; slot < patch.size; ++slot, values += count)
          for (int i = 0; (fields(tile * patch.size + slot) & bits) == bits && i < count; i += 2) {
            values[i] = -far;
            values[i + 1] = far;
          }
      }
  );
}

template <class M, class S>
void find_reach(const PairSurfaces& of, const Directions<M::dimensions>& directions) {
  const Grid& grid = of.grid;
  clear_reach(of);
  for (const Particles& particles : of.sets) {
    if (particles.field != of.pair.a && particles.field != of.pair.b) continue;
    launch(
        "find_reach",
        range(grid.active),
        FindReach<M, S>{
            grid.patch,
            {NodeCopies(grid), directions, particles.field == of.pair.b},
            ParticlesAtNodes<M, S>(grid, of.contact.passes_up, particles),
            bits_of(of.pair),
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

void refine_surface_normals(const ContactBodies& bodies, const ContactNodes& contact) {
  const Grid& grid = bodies.grid;
  const VelocityFields& fields = bodies.fields;
  if (!has_surfaces(fields)) return;
  const Region region("refine_surface_normals");
  visit_kernels(grid, [&](auto mode, auto shape) {
    for (std::size_t i = 0; i < fields.pairs.size(); ++i) {
      if (fields.pairs[i].kind == ContactKind::bonded) continue;
      const PairSurfaces surfaces{
          grid,
          bodies.sets,
          bodies.planes,
          contact,
          fields.pairs[i],
          contact.normal[i],
          contact.reach[i]};
      bool first = true;
      for (const double spread : spreads) {
        compare_directions<decltype(mode), decltype(shape)>(surfaces, spread, first);
        first = false;
      }
    }
  });
}

}  // namespace barreno
