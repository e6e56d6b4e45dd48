// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/own_rows.hpp"

#include "base/exchange.hpp"

namespace barreno {

std::vector<std::size_t> rows_by_owner(
    const Comm& comm, std::size_t rows, const std::function<int(std::size_t)>& owner_of
) {
  std::vector<std::vector<double>> rows_of(static_cast<std::size_t>(comm.getSize()));
  const RowSpan part = part_of_rows(comm, rows);
  for (std::size_t row = part.begin; row < part.end; ++row)
    rows_of[static_cast<std::size_t>(owner_of(row))].push_back(static_cast<double>(row));
  std::vector<std::size_t> own;
  // In rank order: ascending.
  for (const double row : exchange_rows(comm, rows_of))
    own.push_back(static_cast<std::size_t>(row));
  return own;
}

}  // namespace barreno
