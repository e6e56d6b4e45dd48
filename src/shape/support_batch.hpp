// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/rows.hpp"
#include "base/types.hpp"
#include "shape/patch_frame.hpp"

namespace barreno {

/// Particles of a tile that are prepared together, in loops that the compiler vectorises.
inline constexpr int rows_per_batch = 32;

/// Rows of one batch: the k-th is order[begin + k], and the last one again where the batch is not
/// full. All batches then take the same path, and the answer does not depend on their filling.
struct BatchRows {
  int row[rows_per_batch];
  int count = 0;
  bool neighbours = false;  ///< row[k] = row[0] + k for all k, as after rows have been sorted

  KOKKOS_INLINE_FUNCTION BatchRows(const ArrayView<int>& order, int begin, int end)
      : count(end - begin < rows_per_batch ? end - begin : rows_per_batch) {
    int apart = 0;
    for (int k = 0; k < rows_per_batch; ++k) {
      row[k] = order(begin + (k < count ? k : count - 1));
      apart |= row[k] ^ (row[0] + k);
    }
    neighbours = apart == 0;
  }
};

/// visit(k, row) for every row of a batch, in loops that the compiler vectorises. Rows that are
/// neighbours have a loop of their own: their values come as whole vectors, those of other rows one
/// by one, which takes longer than what is computed of them.
template <class Visit>
KOKKOS_FORCEINLINE_FUNCTION void for_each_row_of(const BatchRows& rows, const Visit& visit) {
  if (rows.neighbours) {
    const int first = rows.row[0];
    BARRENO_IVDEP
    for (int k = 0; k < rows_per_batch; ++k) visit(k, first + k);
  } else {
    BARRENO_IVDEP
    for (int k = 0; k < rows_per_batch; ++k) visit(k, rows.row[k]);
  }
}

/// Nodes and weights of a batch, one array per weight.
template <class Support>
struct SupportBatch {
  alignas(64) double value[Support::values][rows_per_batch];
  alignas(64) int slot[Support::slots][rows_per_batch];

  KOKKOS_FORCEINLINE_FUNCTION void put(int k, Support support) {
    int c = 0;
    support.for_each_slot([&](int s) { slot[c++][k] = s; });
    c = 0;
    support.for_each_value([&](double v) { value[c++][k] = v; });
  }
  KOKKOS_INLINE_FUNCTION Support get(int k) const {
    Support out;
    int c = 0;
    out.for_each_slot([&](int& s) { s = slot[c++][k]; });
    c = 0;
    out.for_each_value([&](double& v) { v = value[c++][k]; });
    return out;
  }
};

/// Puts the support of a row into its batch.
template <class M, class S>
struct PutSupport {
  const PatchFrame<M::dimensions>& frame;
  typename PatchFrame<M::dimensions>::First first;
  const ShapeFields& fields;
  SupportBatch<typename S::template Support<M>>& out;

  KOKKOS_FORCEINLINE_FUNCTION void operator()(int k, int row) const {
    out.put(k, S::template support<M>(frame.template geometry<S>(first, fields, row)));
  }
};

/// Supports of the rows of a batch, all in one tile.
template <class M, class S>
KOKKOS_INLINE_FUNCTION void find_supports(
    const PatchFrame<M::dimensions>& frame,
    int tile,
    const BatchRows& rows,
    const ShapeFields& fields,
    SupportBatch<typename S::template Support<M>>& out
) {
  for_each_row_of(rows, PutSupport<M, S>{frame, frame.first(tile), fields, out});
}

}  // namespace barreno
