// SPDX-License-Identifier: BSD-3-Clause
#include "step/particles/relax_pressures.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "shape/kinematics.hpp"
#include "step/particles/shear_of_step.hpp"

#include <cmath>

namespace barreno {
namespace {

/// Rows of one cell in the order of its tile.
struct CellRows {
  int begin, end;
};

template <class M>
struct RelaxPressures {
  double densest;  ///< beyond it a row is too dense
  Dormancy dormancy;
  ArrayView<int> tile_begin, order;
  ArrayView<CellKey> key;
  FieldView volume, mass, stress, modulus, increment;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    if (dormancy.is_left(tile)) return;
    const int end = tile_begin(tile + 1);
    for (int begin = tile_begin(tile), next = begin; begin < end; begin = next) {
      bool dense = false;
      for (; next < end && key(order(next)) == key(order(begin)); ++next)
        dense = dense || is_too_dense(order(next));
      if (dense && next - begin > 1) relax({begin, next});
    }
  }

  KOKKOS_INLINE_FUNCTION bool is_too_dense(int p) const {
    return mass(p, 0) > densest * volume(p, 0);
  }
  KOKKOS_INLINE_FUNCTION double pressure(int p) const {
    return -(stress(p, 0) + stress(p, 1) + stress(p, 2)) / 3.0;
  }
  /// Change of ln V that takes a row to a pressure, to first order.
  KOKKOS_INLINE_FUNCTION double change_to(double common, int p) const {
    return (pressure(p) - common) / modulus(p, 0);
  }

  KOKKOS_INLINE_FUNCTION void relax(CellRows rows) const {
    double all = 0.0, sheared = 0.0, compliance = 0.0, sum = 0.0;
    for (int k = rows.begin; k < rows.end; ++k) {
      const int p = order(k);
      const double own = volume(p, 0) / modulus(p, 0);
      all += volume(p, 0);
      sheared += volume(p, 0) * shear_of_step<M>(increment, p);
      compliance += own;
      sum += own * pressure(p);
    }
    const double common = sum / compliance;
    const double part = part_of(rows, common, pressure_relaxation * sheared / all);
    for (int k = rows.begin; k < rows.end; ++k) {
      const int p = order(k);
      const double own = part * change_to(common, p) / M::dimensions;
      for (int i = 0; i < M::dimensions; ++i) increment_entry<M>(increment, p, i, i) += own;
    }
  }

  /// Of the difference to the common pressure, the same for all rows, so that the cell keeps its
  /// volume.
  KOKKOS_INLINE_FUNCTION double part_of(CellRows rows, double common, double wanted) const {
    double largest = 0.0;
    for (int k = rows.begin; k < rows.end; ++k) {
      const double own = std::fabs(change_to(common, order(k)));
      largest = own > largest ? own : largest;
    }
    const double part = wanted < most_equalised ? wanted : most_equalised;
    return part * largest > largest_volume_change ? largest_volume_change / largest : part;
  }
};

}  // namespace

void relax_pressures(
    const Grid& grid, const Dormancy& dormancy, double reference_density, const Particles& particles
) {
  const Region region("relax_pressures");
  visit_mode(grid.mode, [&](auto mode) {
    launch(
        "relax_pressures",
        range(grid.active),
        RelaxPressures<decltype(mode)>{
            too_dense * reference_density,
            dormancy,
            particles.tile_begin,
            particles.order,
            particles.key,
            particles.volume.values,
            particles.mass.values,
            particles.stress.values,
            particles.longitudinal_modulus.values,
            particles.increment.values}
    );
  });
}

}  // namespace barreno
