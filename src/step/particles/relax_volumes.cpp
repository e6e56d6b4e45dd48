// SPDX-License-Identifier: BSD-3-Clause
#include "step/particles/relax_volumes.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "shape/kinematics.hpp"
#include "step/particles/shear_of_step.hpp"

#include <cmath>

namespace barreno {
namespace {

template <class M>
struct RelaxVolumes {
  double rate, reference_density;
  Dormancy dormancy;
  ArrayView<int> tile_begin, order;
  ArrayView<CellKey> key;
  FieldView volume, mass, increment;

  KOKKOS_INLINE_FUNCTION double log_ratio(int p) const {
    return std::log(volume(p, 0) * reference_density / mass(p, 0));
  }
  KOKKOS_INLINE_FUNCTION static bool is_intact(double log_ratio) {
    return log_ratio < intact_volume && log_ratio > -intact_volume;
  }
  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    if (dormancy.is_left(tile)) return;
    const int end = tile_begin(tile + 1);
    for (int begin = tile_begin(tile), next = begin; begin < end; begin = next) {
      double all = 0.0, sum = 0.0;
      for (; next < end && key(order(next)) == key(order(begin)); ++next) {
        const int p = order(next);
        const double own = log_ratio(p);
        if (!is_intact(own)) continue;
        all += volume(p, 0);
        sum += volume(p, 0) * own;
      }
      if (all > 0.0)
        for (int k = begin; k < next; ++k) relax(order(k), sum / all);
    }
  }

  KOKKOS_INLINE_FUNCTION void relax(int p, double mean) const {
    const double own = log_ratio(p);
    if (!is_intact(own)) return;
    const double wanted = rate * shear_of_step<M>(increment, p);
    const double part = wanted < most_relaxed ? wanted : most_relaxed;
    for (int i = 0; i < M::dimensions; ++i)
      increment_entry<M>(increment, p, i, i) -= part * (own - mean) / M::dimensions;
  }
};

}  // namespace

void relax_volumes(
    const Grid& grid,
    const Dormancy& dormancy,
    double rate,
    double reference_density,
    const Particles& particles
) {
  if (rate == 0.0) return;
  const Region region("relax_volumes");
  visit_mode(grid.mode, [&](auto mode) {
    launch(
        "relax_volumes",
        range(grid.active),
        RelaxVolumes<decltype(mode)>{
            rate,
            reference_density,
            dormancy,
            particles.tile_begin,
            particles.order,
            particles.key,
            particles.volume.values,
            particles.mass.values,
            particles.increment.values}
    );
  });
}

}  // namespace barreno
