// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"
#include "checkpoint/hdf5_file.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace barreno {

/// A file that rank 0 reads and all ranks learn. Every function is collective. @throws FileError on
/// every rank
class SharedFile {
public:
  /// @param file  open, on rank 0
  SharedFile(const Comm& comm, std::shared_ptr<const Hdf5File> file)
      : comm_(comm), file_(std::move(file)) {}

  /// A whole table, of double or long long.
  template <class T>
  std::vector<T> read(const std::string& name) const {
    return read_rows<T>(name, size_of(name), 0);
  }
  /// visit(r, values) for every row of a table in turn. No rank ever holds more than a chunk.
  template <class T, class Visitor>
  void for_each_row(const std::string& name, Visitor&& visit) const {
    const Hdf5Size all = size_of(name);
    const std::size_t most = rows_of_chunk(all.rows, all.columns);
    for (std::size_t first = 0; first < all.rows; first += most) {
      const Hdf5Size part{std::min(most, all.rows - first), all.columns};
      const std::vector<T> values = read_rows<T>(name, part, first);
      for (std::size_t r = 0; r < part.rows; ++r)
        visit(first + r, values.data() + r * part.columns);
    }
  }

private:
  Hdf5Size size_of(const std::string& name) const;
  /// So many rows from the first one on.
  template <class T>
  std::vector<T> read_rows(const std::string& name, const Hdf5Size& part, std::size_t first) const;

  const Comm& comm_;
  std::shared_ptr<const Hdf5File> file_;  ///< root only
};

}  // namespace barreno
