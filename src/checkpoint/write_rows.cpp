// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/write_rows.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <algorithm>

namespace barreno {
namespace {

/// Rows [begin, end) of a table.
struct Span {
  std::size_t begin, end;
};

Span common(const Span& a, const Span& b) {
  return {std::max(a.begin, b.begin), std::min(a.end, b.end)};
}

/// This rank's part of the rows into `values`.
template <class T>
void pack(const SharedTable<T>& table, std::size_t own_begin, const Span& rows, T* values) {
  table.pack(rows.begin - own_begin, rows.end - rows.begin, values);
}

/// Rows of all ranks at the root; at the others `values` is scratch.
template <class T>
void gather_rows(
    const Comm& comm,
    const std::vector<std::size_t>& first,
    const SharedTable<T>& table,
    const Span& rows,
    T* values
) {
  const auto rows_of = [&](std::size_t rank) {
    return common(rows, {first[rank], first[rank + 1]});
  };
  const auto count_of = [&](const Span& part) {
    return static_cast<int>((part.end - part.begin) * table.columns);
  };
  const auto mine = static_cast<std::size_t>(comm.getRank());
  if (!is_root(comm)) {
    const Span part = rows_of(mine);
    if (part.begin >= part.end) return;
    pack(table, first[mine], part, values);
    Teuchos::send<int, T>(comm, count_of(part), values, 0);
    return;
  }
  const auto next = std::upper_bound(first.begin(), first.end(), rows.begin);
  for (auto rank = static_cast<std::size_t>(next - first.begin()) - 1;
       rank + 1 < first.size() && first[rank] < rows.end;
       ++rank) {
    const Span part = rows_of(rank);
    if (part.begin >= part.end) continue;
    T* const place = values + (part.begin - rows.begin) * table.columns;
    if (rank == mine)
      pack(table, first[rank], part, place);
    else
      Teuchos::receive<int, T>(comm, static_cast<int>(rank), count_of(part), place);
  }
}

}  // namespace

std::vector<std::size_t> first_rows(const Comm& comm, int count) {
  const auto ranks = static_cast<std::size_t>(comm.getSize());
  std::vector<int> counts(ranks);
  Teuchos::gatherAll<int, int>(comm, 1, &count, comm.getSize(), counts.data());
  std::vector<std::size_t> first(ranks + 1, 0);
  for (std::size_t r = 0; r < ranks; ++r)
    first[r + 1] = first[r] + static_cast<std::size_t>(counts[r]);
  return first;
}

template <class T>
void write_rows(
    const Comm& comm,
    const std::vector<std::size_t>& first,
    const SharedTable<T>& table,
    RootWork& work,
    const std::unique_ptr<Hdf5File>& file
) {
  const std::size_t all = first.back();
  work.run([&] { file->begin_table<T>(table.name, all, table.columns, table.unit); });
  const std::size_t most = rows_of_chunk(all, table.columns);
  std::vector<T> chunk(most * table.columns + 1);  // the last one for the checksum
  for (std::size_t begin = 0; begin < all; begin += most) {
    const Span rows{begin, std::min(begin + most, all)};
    gather_rows(comm, first, table, rows, chunk.data());
    const auto used = static_cast<std::ptrdiff_t>((rows.end - rows.begin) * table.columns);
    std::fill(chunk.begin() + used, chunk.end(), T{});
    work.run([&] { file->write_chunk(table.name, begin, chunk); });
  }
}
template void
write_rows(const Comm&, const std::vector<std::size_t>&, const SharedTable<double>&, RootWork&, const std::unique_ptr<Hdf5File>&);
template void
write_rows(const Comm&, const std::vector<std::size_t>&, const SharedTable<long long>&, RootWork&, const std::unique_ptr<Hdf5File>&);

}  // namespace barreno
