// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"
#include "checkpoint/hdf5_file.hpp"
#include "checkpoint/write_rows.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace barreno {

/// This rank's equal part of so many rows.
inline RowSpan part_of_rows(const Comm& comm, std::size_t rows) {
  const auto ranks = static_cast<std::size_t>(comm.getSize());
  const auto rank = static_cast<std::size_t>(comm.getRank());
  return {rows * rank / ranks, rows * (rank + 1) / ranks};
}

/// visit(r, values) for the rows of a table that are this rank's equal part of all, for work that
/// any rank may do.
/// @tparam T  double or long long
template <class T, class Visitor>
void for_part_of_rows(
    const Comm& comm, const Hdf5File& file, const std::string& name, Visitor&& visit
) {
  const Hdf5Size all = file.size_of(name);
  const RowSpan part = part_of_rows(comm, all.rows);
  const std::size_t most = rows_of_chunk(all.rows, all.columns);
  for (std::size_t first = part.begin; first < part.end; first += most) {
    const std::size_t count = std::min(most, part.end - first);
    const std::vector<T> values = file.read_rows<T>(name, first, count);
    for (std::size_t r = 0; r < count; ++r) visit(first + r, values.data() + r * all.columns);
  }
}

/// Row numbers of a table by the rank that they belong to: every rank says of its equal part of
/// them whose they are. Collective.
/// @param rows      of the table
/// @param owner_of  the owner of a row of this rank's part
/// @return this rank's rows, ascending
std::vector<std::size_t> rows_by_owner(
    const Comm& comm, std::size_t rows, const std::function<int(std::size_t)>& owner_of
);

/// visit(p, values) for the p-th of this rank's rows of a table, which are read with what lies
/// between them where that is less than 64 kB. @throws FileError
/// @tparam T  double or long long
/// @param rows  ascending
template <class T, class Visitor>
void for_own_rows(
    const std::vector<std::size_t>& rows,
    const Hdf5File& file,
    const std::string& name,
    Visitor&& visit
) {
  constexpr std::size_t gap_numbers = 8192;
  const Hdf5Size all = file.size_of(name);
  const std::size_t most = rows_of_chunk(all.rows, all.columns);
  const std::size_t gap =
      std::max<std::size_t>(gap_numbers / std::max<std::size_t>(all.columns, 1), 1);
  for (std::size_t p = 0; p < rows.size();) {
    const std::size_t first = rows[p];
    std::size_t end = p + 1;
    while (end < rows.size() && rows[end] - rows[end - 1] <= gap && rows[end] - first < most) ++end;
    const std::vector<T> values = file.read_rows<T>(name, first, rows[end - 1] - first + 1);
    for (; p < end; ++p)
      visit(static_cast<int>(p), values.data() + (rows[p] - first) * all.columns);
  }
}

}  // namespace barreno
