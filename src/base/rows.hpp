// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/launch.hpp"

#include <algorithm>
#include <type_traits>

namespace barreno {

/// Rows that kernels take one after the other: their sums have one order.
inline constexpr int rows_per_run = 64;

/// What a step does to a run: rows that it leaves as they are may be all of it, or some.
enum RunPart : unsigned char { whole_run, part_of_run, no_part_of_run };

/// Rows [begin, end) of a particle set.
struct Rows {
  int begin = 0, end = 0;
  const unsigned char* runs = nullptr;  ///< RunPart of each run of the set; null: all of every run

  KOKKOS_INLINE_FUNCTION bool skips(int row) const {
    return runs != nullptr && runs[row / rows_per_run] == no_part_of_run;
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
void for_each_block(int count, Update&& update, const unsigned char* runs = nullptr) {
  for (int begin = 0; begin < count; begin += std::min(rows_per_block, count - begin))
    update(Rows{begin, begin + std::min(rows_per_block, count - begin), runs});
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

/// Short runs of rows, each of which the compiler may vectorise: body(row) must touch its own row
/// only.
template <class Body>
void for_each_row(const char* label, Rows rows, const Body& body) {
  const int runs = (rows.end - rows.begin + rows_per_run - 1) / rows_per_run;
  launch(
      label,
      range(runs),
      KOKKOS_LAMBDA(const int r) {
        const int begin = rows.begin + r * rows_per_run;
        const int end = begin + rows_per_run < rows.end ? begin + rows_per_run : rows.end;
        if (rows.skips(begin)) return;
        BARRENO_IVDEP
        for (int p = begin; p < end; ++p) body(p);
      }
  );
}

}  // namespace barreno
