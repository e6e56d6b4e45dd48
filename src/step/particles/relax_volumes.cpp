// SPDX-License-Identifier: BSD-3-Clause
#include "step/particles/relax_volumes.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "shape/kinematics.hpp"

#include <cmath>

namespace barreno {
namespace {

template <class M>
struct RelaxVolumes {
  static constexpr int dimensions = M::dimensions;

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
  /// dt L_ij; the hoop strain is entry 4 in two dimensions.
  KOKKOS_INLINE_FUNCTION double& entry(int p, int i, int j) const {
    return increment(p, dimensions * i + j);
  }

  /// Norm of the deviator of dt D, the symmetric part of dt L.
  KOKKOS_INLINE_FUNCTION double shear(int p) const {
    const double hoop = dimensions == 2 ? increment(p, 4) : 0.0;
    double trace = hoop, squares = hoop * hoop;
    for (int i = 0; i < dimensions; ++i) {
      trace += entry(p, i, i);
      squares += entry(p, i, i) * entry(p, i, i);
      for (int j = 0; j < i; ++j) {
        const double twice = entry(p, i, j) + entry(p, j, i);
        squares += 0.5 * twice * twice;
      }
    }
    const double of_deviator = squares - trace * trace / 3.0;
    return of_deviator > 0.0 ? std::sqrt(of_deviator) : 0.0;
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
    const double wanted = rate * shear(p);
    const double part = wanted < most_relaxed ? wanted : most_relaxed;
    for (int i = 0; i < dimensions; ++i) entry(p, i, i) -= part * (own - mean) / dimensions;
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
