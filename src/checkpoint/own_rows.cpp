// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/own_rows.hpp"

#include "base/exchange.hpp"
#include "base/rank_work.hpp"

namespace barreno {

std::vector<std::size_t> rows_by_owner(
    const Comm& comm,
    const Hdf5File& file,
    const std::string& name,
    const std::function<int(const double*)>& owner_of
) {
  std::vector<std::vector<double>> rows_of(static_cast<std::size_t>(comm.getSize()));
  RankWork work(comm);
  work.run([&] {
    for_part_of_rows<double>(comm, file, name, [&](std::size_t row, const double* values) {
      rows_of[static_cast<std::size_t>(owner_of(values))].push_back(static_cast<double>(row));
    });
  });
  work.agree();
  std::vector<double> send;
  std::vector<int> counts;
  for (const std::vector<double>& rows : rows_of) {
    send.insert(send.end(), rows.begin(), rows.end());
    counts.push_back(static_cast<int>(rows.size()));
  }
  const std::vector<double> received = exchange(comm, send, counts);  // in rank order: ascending
  std::vector<std::size_t> own;
  own.reserve(received.size());
  for (const double row : received) own.push_back(static_cast<std::size_t>(row));
  return own;
}

}  // namespace barreno
