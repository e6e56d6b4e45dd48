// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/points.hpp"
#include "state/state.hpp"

#include <barreno/history_values.hpp>
#include <barreno/outcome.hpp>
#include <barreno/real.hpp>
#include <barreno/tensor.hpp>
#include <type_traits>

namespace barreno {

/// A model's history of one or several points, and the R that it is updated with: Lanes where the
/// model takes them, as update_points() or in parts.
template <class Model, class R>
struct HistoryFor {
  using type = typename Model::template HistoryOf<R>;
};
template <class Model>
struct HistoryFor<Model, double> {
  using type = typename Model::History;
};
template <class Model, class = void>
struct RealFor {
  using type = double;
};
#if BARRENO_HAS_LANES
template <class Model>
struct RealFor<Model, std::void_t<typename Model::template HistoryOf<Lanes>>> {
  using type = Lanes;
};
#endif

/// Neighbouring rows that go through the update together.
template <class Model, class R>
struct PointGroup {
  using History = typename HistoryFor<Model, R>::type;
  int first, count;

  KOKKOS_INLINE_FUNCTION R get(const Field& field, int c = 0) const {
    return load<R>(field.values, c, first, count);
  }
  KOKKOS_INLINE_FUNCTION void put(const R& value, const Field& field, int c = 0) const {
    store(value, field.values, c, first, count);
  }
  /// Asks for rows further on, so that they arrive while this group is updated: many arrays are
  /// read for the first time in the step, more than the processor follows by itself. An address
  /// beyond the array is no error.
  KOKKOS_INLINE_FUNCTION void prefetch(const Field& field) const {
#ifdef __GNUC__
    constexpr int rows_of_line = 8, ahead = 32;
    for (int c = 0; c < field.components; ++c)
      for (int i = 0; i < width<R>; i += rows_of_line)
        __builtin_prefetch(&field.values(first, c) + ahead + i, 1);
#endif
  }
  /// `components` of a symmetric tensor: 4 in two dimensions, where yz and zx are zero.
  KOKKOS_INLINE_FUNCTION Sym3Of<R> get_tensor(const Field& field, int components) const {
    Sym3Of<R> t{get(field, 0), get(field, 1), get(field, 2), get(field, 3), R{}, R{}};
    if (components == 4) return t;
    t.yz = get(field, 4);
    t.zx = get(field, 5);
    return t;
  }
  KOKKOS_INLINE_FUNCTION void put_tensor(const Sym3Of<R>& t, const Field& field, int components)
      const {
    put(t.xx, field, 0);
    put(t.yy, field, 1);
    put(t.zz, field, 2);
    put(t.xy, field, 3);
    if (components == 4) return;
    put(t.yz, field, 4);
    put(t.zx, field, 5);
  }
  KOKKOS_INLINE_FUNCTION History get_history(const Field& field) const {
    History history{};
    for (int c = 0; c < Model::history_count; ++c)
      history_values<Model, R>(history)[c] = get(field, c);
    return history;
  }
  /// Only where `good`.
  KOKKOS_INLINE_FUNCTION void put_history(
      const MaskOf<R>& good, const History& history, const Field& field
  ) const {
    for (int c = 0; c < Model::history_count; ++c)
      put(real::select(good, history_values<Model, R>(history)[c], get(field, c)), field, c);
  }
};

/// Whether a model's update has two parts, start_points() and finish_points()
/// (barreno/outcome.hpp).
template <class Model, class R, class = void>
inline constexpr bool updates_in_parts = false;
template <class Model, class R>
inline constexpr bool
    updates_in_parts<Model, R, std::enable_if_t<(Model::groups_together > 0) && (width<R> > 1)>> =
        true;

#if BARRENO_HAS_LANES
template <class Model>
PointsOutcome<Lanes> update_points(
    const Model& model,
    const IncrementOf<Sym3Of<Lanes>>& increment,
    Sym3Of<Lanes>& stress,
    typename Model::template HistoryOf<Lanes>& history
) {
  return model.update_points(increment, stress, history);
}
#endif
template <class Model>
KOKKOS_INLINE_FUNCTION PointsOutcome<double> update_points(
    const Model& model,
    const IncrementOf<Sym3>& increment,
    Sym3& stress,
    typename Model::History& history
) {
  const Outcome outcome = model.update(increment, stress, history);
  return {
      !outcome.failed(), outcome.elastic_work, outcome.plastic_work, outcome.longitudinal_modulus};
}

}  // namespace barreno
