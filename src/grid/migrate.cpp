// SPDX-License-Identifier: BSD-3-Clause
#include "grid/migrate.hpp"

#include "base/exchange.hpp"

namespace barreno {

std::vector<double> exchange_rows(
    const Teuchos::Comm<int>& comm, const std::vector<std::vector<double>>& outgoing
) {
  std::vector<int> counts;
  std::vector<double> send;
  counts.reserve(outgoing.size());
  for (const std::vector<double>& rows : outgoing) {
    counts.push_back(static_cast<int>(rows.size()));
    send.insert(send.end(), rows.begin(), rows.end());
  }
  return exchange(comm, send, counts);
}

}  // namespace barreno
