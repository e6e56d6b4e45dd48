// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"
#include "checkpoint/hdf5_file.hpp"

#include <functional>
#include <memory>
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

/// Writes a table chunk by chunk: every rank packs and sends its rows of a chunk, rank 0 writes
/// them while the others pack their next ones, and no rank holds more than a chunk. Collective,
/// also where the root's work has failed.
/// @tparam T  double or long long
/// @param first  first_rows()
template <class T>
void write_rows(
    const Comm& comm,
    const std::vector<std::size_t>& first,
    const SharedTable<T>& table,
    RootWork& work,
    const std::unique_ptr<Hdf5File>& file
);

}  // namespace barreno
