// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/launch.hpp"

#include <algorithm>
#include <type_traits>

namespace barreno {

/// Rows that kernels take one after the other: their sums have one order.
inline constexpr int rows_per_chunk = 64;

/// Which rows of a chunk a step updates: those of dormant tiles may be all of it, or some.
enum ChunkPart : unsigned char { whole_chunk, part_of_chunk, no_part_of_chunk };

/// Rows [begin, end) of a particle set.
struct Rows {
  int begin = 0, end = 0;
  const unsigned char* chunks =
      nullptr;  ///< ChunkPart of each chunk of the set; null: all of every chunk

  KOKKOS_INLINE_FUNCTION bool skips(int row) const {
    return chunks != nullptr && chunks[row / rows_per_chunk] == no_part_of_chunk;
  }
};

inline RowPolicy range(Rows rows) {
  return {rows.begin, rows.end};
}

/// Rows that pass through all particle updates before the next ones do: their fields stay in the
/// cache. A device wants them all at once.
inline constexpr int rows_per_block =
    std::is_same<MemorySpace, Kokkos::HostSpace>::value ? 2048 : 1 << 30;

/// update(rows) for block after block of [0, count).
template <class Update>
void for_each_block(int count, Update&& update, const unsigned char* chunks = nullptr) {
  for (int begin = 0; begin < count; begin += std::min(rows_per_block, count - begin))
    update(Rows{begin, begin + std::min(rows_per_block, count - begin), chunks});
}

#if defined(__GNUC__) && !defined(__clang__)
#define BARRENO_IVDEP _Pragma("GCC ivdep")
#elif defined(__clang__)
#define BARRENO_IVDEP _Pragma("clang loop vectorize(assume_safety)")
#else
#define BARRENO_IVDEP
#endif

/// Before a loop of a few rounds, whose branches depend on the round alone.
#if defined(__clang__)
#define BARRENO_UNROLL _Pragma("clang loop unroll(full)")
#elif defined(__GNUC__)
#define BARRENO_UNROLL _Pragma("GCC unroll 8")
#else
#define BARRENO_UNROLL
#endif

/// Chunks of rows, each of which the compiler may vectorise: body(row) must touch its own row
/// only.
template <class Body>
void for_each_row(const char* label, Rows rows, const Body& body) {
  const int chunks = (rows.end - rows.begin + rows_per_chunk - 1) / rows_per_chunk;
  launch(
      label,
      range(chunks),
      KOKKOS_LAMBDA(const int r) {
        const int begin = rows.begin + r * rows_per_chunk;
        const int end = begin + rows_per_chunk < rows.end ? begin + rows_per_chunk : rows.end;
        if (rows.skips(begin)) return;
        BARRENO_IVDEP
        for (int p = begin; p < end; ++p) body(p);
      }
  );
}

}  // namespace barreno
