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

/// The first N components of a field for the rows of a batch, the k-th of each.
///
/// Rows that are neighbours are read where they are, as whole vectors. Others are collected one by
/// one before, which takes longer than what is computed of them. What is computed has one loop for
/// both: its bits do not depend on the rows, which ranks and restarts change, as those of two loops
/// would.
template <unsigned N>
struct BatchColumns {
  const double* column[N];
  alignas(64) double collected[N][rows_per_batch];

  BatchColumns() = default;
  BatchColumns(const BatchColumns&) = delete;  // columns may be its own

  template <class Columns>
  KOKKOS_INLINE_FUNCTION void load(const Columns& field, const BatchRows& rows) {
    for (int c = 0; c < static_cast<int>(N); ++c) {
      if (rows.neighbours) {
        column[c] = &field(rows.row[0], c);
      } else {
        for (int k = 0; k < rows_per_batch; ++k) collected[c][k] = field(rows.row[k], c);
        column[c] = collected[c];
      }
    }
  }
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int k, int c = 0) const { return column[c][k]; }
};
template <>
struct BatchColumns<0> {
  template <class Columns>
  KOKKOS_INLINE_FUNCTION void load(const Columns&, const BatchRows&) {}
};

/// What shape function S reads of the particles of a batch.
template <class M, class S>
struct ShapeColumns {
  static constexpr unsigned dimensions = M::dimensions;
  static constexpr bool turns =
      S::follows_deformation && S::form == ParticleForm::box && dimensions == 3;
  BatchColumns<dimensions> position, half_size;
  BatchColumns<S::follows_deformation ? dimensions * dimensions : 0> deformation;
  BatchColumns<turns ? 4 : 0> rotation;

  KOKKOS_INLINE_FUNCTION ShapeColumns(const ShapeFields& fields, const BatchRows& rows) {
    position.load(fields.position, rows);
    half_size.load(fields.half_size, rows);
    deformation.load(fields.deformation, rows);
    rotation.load(fields.rotation, rows);
  }
};

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

/// Supports of the rows of a batch, all in one tile.
template <class M, class S>
KOKKOS_INLINE_FUNCTION void find_supports(
    const PatchFrame<M::dimensions>& frame,
    int tile,
    const BatchRows& rows,
    const ShapeFields& fields,
    SupportBatch<typename S::template Support<M>>& out
) {
  const auto first = frame.first(tile);
  const ShapeColumns<M, S> columns(fields, rows);
  BARRENO_IVDEP
  for (int k = 0; k < rows_per_batch; ++k)
    out.put(k, S::template support<M>(frame.template geometry<S>(first, columns, k)));
}

}  // namespace barreno
