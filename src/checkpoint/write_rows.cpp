// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/write_rows.hpp"

#include "checkpoint/hdf5_file.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <algorithm>

namespace barreno {

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
    const SharedTable<T>& table, unsigned long long place, const RowSpan& own, RowFile& file
) {
  const std::size_t rows = own.end - own.begin, most = rows_of_chunk(rows, table.columns);
  std::vector<T> values(most * table.columns);
  for (std::size_t begin = 0; begin < rows; begin += most) {
    const std::size_t count = std::min(most, rows - begin);
    table.pack(begin, count, values.data());
    const std::size_t row_bytes = table.columns * sizeof(T);
    file.write(values.data(), count * row_bytes, place + (own.begin + begin) * row_bytes);
  }
}
template void write_rows(const SharedTable<double>&, unsigned long long, const RowSpan&, RowFile&);
template void
write_rows(const SharedTable<long long>&, unsigned long long, const RowSpan&, RowFile&);

}  // namespace barreno
