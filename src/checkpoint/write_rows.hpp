// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"
#include "checkpoint/row_file.hpp"

#include <functional>
#include <string>
#include <vector>

namespace barreno {

/// The first row of each rank, and behind the last one all rows. Collective.
std::vector<std::size_t> first_rows(const Comm& comm, int count);

/// A table of the rows of all ranks, rank after rank.
template <class T>
struct SharedTable {
  std::string name, unit;
  std::size_t columns = 1;
  /// pack(first, count, values): so many of this rank's own rows, row after row.
  std::function<void(std::size_t, std::size_t, T*)> pack;
};

/// Rows [begin, end) of a table.
struct RowSpan {
  std::size_t begin = 0, end = 0;
};

/// Writes this rank's rows of a table, which no other rank knows of; no more than 1 MB of them are
/// packed at a time. @throws FileError
/// @tparam T  double or long long
/// @param place  where the table begins in the file (Hdf5File::lay_out)
/// @param own    this rank's rows
template <class T>
void write_rows(
    const SharedTable<T>& table, unsigned long long place, const RowSpan& own, RowFile& file
);

}  // namespace barreno
