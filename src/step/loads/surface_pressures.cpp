// SPDX-License-Identifier: BSD-3-Clause
#include "step/loads/surface_pressures.hpp"

#include "base/gather.hpp"
#include "base/launch.hpp"
#include "base/region.hpp"
#include "base/row_sum.hpp"
#include "shape/kinematics.hpp"
#include "shape/support_batch.hpp"
#include "state/shape_fields.hpp"
#include "step/loads/loaded_sets.hpp"

#include <array>

namespace barreno {
namespace {

/// A pressure inside a particle and its gradient there now.
struct PressureInside {
  double value = 0.0, gradient[3] = {};
};

/// p e and p F^-T grad e of the loads on a particle; pressure_of(index of a load).
template <class M, class Pressure>
KOKKOS_INLINE_FUNCTION PressureInside pressure_inside(
    const LoadTable& loads, const Particles& particles, int p, const Pressure& pressure_of
) {
  constexpr int parts = 1 + M::dimensions;
  double sum[extent<parts>] = {};
  loads.for_each_face(particles, p, [&](int surface, int load) {
    if (!loads.loads(load).on_surfaces) return;
    const double pressure = pressure_of(load);
    for (int c = 0; c < parts; ++c)
      sum[c] += pressure * particles.surface_share(p, surface * parts + c);
  });
  const auto f = load_tensor<M>(particles.deformation_gradient.values, p);
  const auto c = cofactors(f);
  const double scale = 1.0 / determinant(f);
  PressureInside inside{sum[0], {}};
  if constexpr (M::dimensions == 3) {
    inside.gradient[0] = scale * (c.xx * sum[1] + c.xy * sum[2] + c.xz * sum[3]);
    inside.gradient[1] = scale * (c.yx * sum[1] + c.yy * sum[2] + c.yz * sum[3]);
    inside.gradient[2] = scale * (c.zx * sum[1] + c.zy * sum[2] + c.zz * sum[3]);
  } else {
    inside.gradient[0] = scale * (c.xx * sum[1] + c.xy * sum[2]);
    inside.gradient[1] = scale * (c.yx * sum[1] + c.yy * sum[2]);
  }
  return inside;
}

/// Force of a pressure inside a particle on a node: V (value grad S + gradient S), turned round.
template <class M>
KOKKOS_INLINE_FUNCTION void node_force(
    const PressureInside& inside,
    double volume,
    double s,
    const double* slope,
    double hoop,
    double (&force)[M::dimensions]
) {
  for (int d = 0; d < M::dimensions; ++d)
    force[d] = -volume * (inside.value * slope[d] + inside.gradient[d] * s);
  if constexpr (M::hoop) force[0] -= volume * inside.value * hoop;
}

/// Power of a pressure inside a particle on its nodes, with a part of the step's increment taken
/// from the velocity after it: a half for the mean velocity.
template <class M, class Support>
KOKKOS_INLINE_FUNCTION double power_of(
    const PressureInside& inside,
    double volume,
    const Support& support,
    const Patch& sizes,
    const double* motion,
    double part
) {
  double power = 0.0;
  support.for_each_node(sizes, [&](int slot, double s, const double* slope, double hoop) {
    double force[M::dimensions];
    node_force<M>(inside, volume, s, slope, hoop, force);
    const double* const node = motion + slot * motion_components(M::dimensions);
    for (int d = 0; d < M::dimensions; ++d)
      power += force[d] * (node[d] - part * node[M::dimensions + d]);
  });
  return power;
}

/// The particles of one set in balls that loads press.
template <class M, class S>
struct PressedRows : LoadedSet<M, S> {
  using Set = LoadedSet<M, S>;
  using Set::frame;
  using Set::loads;
  using Set::nodes;
  using Set::particles;

  /// visit(row, its support) for those in a tile.
  template <class Visitor>
  KOKKOS_INLINE_FUNCTION void for_each(int tile, Visitor&& visit) const {
    if (loads.loaded_tiles(tile) == 0) return;
    SupportBatch<typename S::template Support<M>> supports;
    const int end = particles.tile_begin(tile + 1);
    for (int k = particles.tile_begin(tile); k < end; k += rows_per_batch) {
      const BatchRows rows(particles.order, k, end);
      find_supports<M, S>(frame, tile, rows, shape_fields(particles), supports);
      for (int i = 0; i < rows.count; ++i)
        if (particles.loaded_faces(rows.row[i]) != 0.0) visit(rows.row[i], supports.get(i));
    }
  }
  KOKKOS_INLINE_FUNCTION PressureInside pressure(int p) const {
    return pressure_inside<M>(loads, particles, p, [&](int load) {
      return loads.loads(load).pressure;
    });
  }
  KOKKOS_INLINE_FUNCTION PressureInside unit_pressure(int p, int of) const {
    return pressure_inside<M>(loads, particles, p, [&](int load) {
      return load == of ? 1.0 : 0.0;
    });
  }
};

template <class M, class S>
struct ProjectSurfacePressures {
  PressedRows<M, S> pressed;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    const Nodes& nodes = pressed.nodes;
    if (nodes.keeps_sums(tile)) return;
    const Patch& sizes = pressed.frame.patch;
    double* const patch = &nodes.sums(first_sum(sizes, tile));
    pressed.for_each(tile, [&](int p, const auto& support) {
      const PressureInside inside = pressed.pressure(p);
      const double volume = pressed.particles.volume(p);
      support.for_each_node(sizes, [&](int slot, double s, const double* slope, double hoop) {
        double force[M::dimensions];
        node_force<M>(inside, volume, s, slope, hoop, force);
        double* const node = patch + slot * sum_components + first_force(M::dimensions);
        for (int d = 0; d < M::dimensions; ++d) node[d] += force[d];
      });
    });
  }
};

template <class M, class S>
struct TallySurfacePressures {
  PressedRows<M, S> pressed;

  KOKKOS_INLINE_FUNCTION void operator()(int tile, LoadTally& tally) const {
    if (!pressed.ends_step(tile)) return;
    const Patch& sizes = pressed.frame.patch;
    const double dt = pressed.frame.tile_frame(tile).dt;
    const double* const motion = pressed.motion_of(tile);
    pressed.for_each(tile, [&](int p, const auto& support) {
      const PressureInside inside = pressed.pressure(p);
      const double volume = pressed.particles.volume(p);
      tally.work += dt * power_of<M>(inside, volume, support, sizes, motion, 0.5);
      // The weights add up to 1 and their slopes to 0.
      tally.impulse -= dt * volume * inside.gradient[1];
    });
    tally.work.carry();
    tally.impulse.carry();
  }
};

/// Growth of a cavity over its volume at the start.
struct CavityGrowth {
  ReproducibleSum share;
};
KOKKOS_INLINE_FUNCTION void add(const CavityGrowth& part, CavityGrowth& sum) {
  sum.share += part.share;
}

template <class M, class S>
struct GrowCavity {
  PressedRows<M, S> pressed;
  int load;
  double initial_volume;

  KOKKOS_INLINE_FUNCTION void operator()(int tile, CavityGrowth& growth) const {
    const Patch& sizes = pressed.frame.patch;
    const double dt = pressed.frame.tile_frame(tile).part;
    const double* const motion = &pressed.nodes.motion(first_motion(sizes, tile));
    pressed.for_each(tile, [&](int p, const auto& support) {
      const PressureInside inside = pressed.unit_pressure(p, load);
      const double volume = pressed.particles.volume(p);
      const double grown = dt * power_of<M>(inside, volume, support, sizes, motion, 0.0);
      growth.share += grown / initial_volume;
    });
    growth.share.carry();
  }
};

template <class M, class S>
void launch_surface_projection(int tiles, const LoadedSet<M, S>& set) {
  launch("project_surface_pressures", range(tiles), ProjectSurfacePressures<M, S>{{set}});
}
template <class M, class S>
LoadTally launch_tally(int tiles, const LoadedSet<M, S>& set) {
  LoadTally tally;
  launch_reduction(
      "tally_surface_pressures",
      range(tiles),
      TallySurfacePressures<M, S>{{set}},
      TallyReducer<LoadTally>(tally)
  );
  return tally;
}
template <class M, class S>
CavityGrowth launch_growth(int tiles, const LoadedSet<M, S>& set, int load, double initial_volume) {
  CavityGrowth growth;
  launch_reduction(
      "grow_cavities",
      range(tiles),
      GrowCavity<M, S>{{set}, load, initial_volume},
      TallyReducer<CavityGrowth>(growth)
  );
  return growth;
}

}  // namespace

void project_surface_pressures(const Tractions& tractions) {
  if (!tractions.loads.any_on_surfaces) return;
  const Region region("project_surface_pressures");
  for_each_loaded_set(tractions, &Particles::surface_share, [&](const auto& set) {
    launch_surface_projection(tractions.grid.active, set);
  });
}

ReproducibleSum tally_surface_pressures(const Tractions& tractions, OwnLedger& ledger) {
  if (!tractions.loads.any_on_surfaces) return {};
  const Region region("tally_surface_pressures");
  LoadTally sum;
  for_each_loaded_set(tractions, &Particles::surface_share, [&](const auto& set) {
    add(launch_tally(tractions.grid.active, set), sum);
  });
  ledger.load_impulse += sum.impulse;
  ledger.boundary_work += sum.work;
  return sum.work;
}

void grow_cavities(const Tractions& tractions, std::vector<Cavity>& cavities) {
  if (!tractions.loads.any_on_surfaces) return;
  const Region region("grow_cavities");
  for (std::size_t l = 0; l < cavities.size(); ++l) {
    Cavity& cavity = cavities[l];
    if (!cavity.holds_fluid()) continue;
    CavityGrowth sum;
    for_each_loaded_set(tractions, &Particles::surface_share, [&](const auto& set) {
      add(launch_growth(tractions.grid.active, set, static_cast<int>(l), cavity.initial_volume),
          sum);
    });
    std::array<ReproducibleSum, 1> share{sum.share};
    sum_over_ranks(*tractions.grid.comm, share);
    cavity.volume += cavity.initial_volume * share[0].value();
  }
}

}  // namespace barreno
