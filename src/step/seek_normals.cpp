// SPDX-License-Identifier: BSD-3-Clause
#include "step/seek_normals.hpp"

#include "base/launch.hpp"
#include "base/numbers.hpp"
#include "base/region.hpp"
#include "grid/halo.hpp"
#include "shape/visit_kernels.hpp"
#include "state/shape_fields.hpp"
#include "step/directions.hpp"
#include "step/mirrors.hpp"
#include "step/node_copies.hpp"
#include "step/particle_ellipse.hpp"

#include <limits>

namespace barreno {
namespace {

/// Spreads of the rounds; the last leaves the directions 0.6 degrees apart.
constexpr double spreads[] = {40.0 / 360.0 * two_pi, 10.0 / 360.0 * two_pi, 2.5 / 360.0 * two_pi};
/// By how much another direction must be better [cells].
constexpr double margin = 1e-3;

template <class M, class S>
struct FindReach {
  static constexpr unsigned extent = M::dimensions;
  static constexpr int dimensions = M::dimensions;
  static constexpr int count = Directions<extent>::count;
  PatchFrame<M::dimensions> frame;
  NodeCopies copies;
  Directions<extent> directions;
  Particles particles;
  bool second;  ///< the set belongs to the pair's second field
  ArrayView<unsigned char> shared_tile, fields;
  ArrayView<double> normal, reach;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    if (shared_tile(tile) == 0) return;
    constexpr int normals = normal_components(dimensions);
    const auto first = frame.first(tile);
    const double* const n = &normal(first_value(frame.patch, tile, normals));
    double* const out = &reach(first_value(frame.patch, tile, 2 * count));
    for (int k = particles.tile_begin(tile); k < particles.tile_begin(tile + 1); ++k) {
      const int p = particles.order(k);
      const ParticlePlace place = frame.template place<S>(first, shape_fields(particles), p);
      const ParticleEllipse<extent> ellipse(frame, place, particles, p);
      S::template support<M>(place).for_each_node(
          frame.patch,
          [&](int slot, double s, const double*, double) {
            if (s > 0.0 && fields(tile * frame.patch.size + slot) != 0)
              extend(ellipse, slot, n + slot * normals, out + slot * 2 * count);
          }
      );
    }
  }
  KOKKOS_INLINE_FUNCTION void extend(
      const ParticleEllipse<extent>& ellipse, int slot, const double* n, double* out
  ) const {
    int at[3];
    copies.place(slot, at);
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
  ArrayView<TilePlace> tile_place;
  Mirrors mirrors;
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

  /// At a mirror the fit has said all that there is to say.
  KOKKOS_INLINE_FUNCTION bool mirrored(int tile, int slot) const {
    int at[3];
    copies.place(slot, at);
    bool found = false;
    for (int d = 0; d < dimensions; ++d)
      found =
          found || mirrors.holds(
                       d, tile_place(tile)[d] * copies.patch.tile_cells - copies.patch.reach + at[d]
                   );
    return found;
  }

  KOKKOS_INLINE_FUNCTION void choose(int tile, int slot, double* n) const {
    double best = gap(tile, slot, 0);
    const double enough = best + margin;
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

void clear_reach(const State& state, const ArrayView<double>& reach) {
  const Patch patch = state.grid.patch;
  const int count = 2 * directions_about(patch.dimensions);
  const auto shared_tile = state.contact.shared_tile;
  constexpr double far = std::numeric_limits<double>::max();
  launch(
      "clear_reach",
      range(state.grid.active),
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

template <class M, class S>
void find_reach(
    const Scene& scene,
    const Directions<M::dimensions>& directions,
    std::size_t index,
    const State& state
) {
  const FieldPair& pair = state.fields.pairs[index];
  const ContactNodes& contact = state.contact;
  clear_reach(state, contact.reach[index]);
  for (const Particles& particles : state.particles) {
    if (particles.field != pair.a && particles.field != pair.b) continue;
    launch(
        "find_reach",
        range(state.grid.active),
        FindReach<M, S>{
            PatchFrame<M::dimensions>(scene, state.grid),
            NodeCopies(state.grid),
            directions,
            particles,
            particles.field == pair.b,
            contact.shared_tile,
            contact.fields,
            contact.normal[index],
            contact.reach[index]}
    );
  }
  exchange_halo(
      state.grid, contact.reach[index], state.grid.patch.size * 2 * directions_about(M::dimensions)
  );
}

template <class M, class S>
void seek_round(const Scene& scene, double spread, bool axes, std::size_t index, State& state) {
  const FieldPair& pair = state.fields.pairs[index];
  const ContactNodes& contact = state.contact;
  const Directions<M::dimensions> directions(spread, axes);
  find_reach<M, S>(scene, directions, index, state);
  launch(
      "choose_normals",
      range(state.grid.active),
      ChooseNormals<M::dimensions>{
          NodeCopies(state.grid),
          state.grid.tile_place,
          Mirrors(scene, state.grid),
          directions,
          1U << static_cast<unsigned>(pair.a) | 1U << static_cast<unsigned>(pair.b),
          contact.shared_tile,
          contact.fields,
          contact.normal[index],
          contact.reach[index]}
  );
}

}  // namespace

void seek_normals(const Scene& scene, State& state) {
  if (scene.contacts.empty()) return;
  const Region region("seek_normals");
  visit_kernels(scene, [&](auto mode, auto shape) {
    for (std::size_t i = 0; i < state.fields.pairs.size(); ++i) {
      if (state.fields.pairs[i].kind == ContactKind::bonded) continue;
      bool first = true;
      for (const double spread : spreads) {
        seek_round<decltype(mode), decltype(shape)>(scene, spread, first, i, state);
        first = false;
      }
    }
  });
}

}  // namespace barreno
