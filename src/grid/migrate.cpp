// SPDX-License-Identifier: BSD-3-Clause
#include "grid/migrate.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <mpi.h>

namespace barreno {

std::vector<double> exchange_rows(
    const Teuchos::Comm<int>& comm, const std::vector<std::vector<double>>& outgoing
) {
  MPI_Comm mpi = *dynamic_cast<const Teuchos::MpiComm<int>&>(comm).getRawMpiComm();
  const auto ranks = outgoing.size();
  std::vector<int> send_counts(ranks), receive_counts(ranks), send_starts(ranks),
      receive_starts(ranks);
  std::vector<double> send;
  for (std::size_t r = 0; r < ranks; ++r) {
    send_starts[r] = static_cast<int>(send.size());
    send_counts[r] = static_cast<int>(outgoing[r].size());
    send.insert(send.end(), outgoing[r].begin(), outgoing[r].end());
  }
  MPI_Alltoall(send_counts.data(), 1, MPI_INT, receive_counts.data(), 1, MPI_INT, mpi);
  int total = 0;
  for (std::size_t r = 0; r < ranks; ++r) {
    receive_starts[r] = total;
    total += receive_counts[r];
  }
  std::vector<double> received(static_cast<std::size_t>(total));
  MPI_Alltoallv(
      send.data(),
      send_counts.data(),
      send_starts.data(),
      MPI_DOUBLE,
      received.data(),
      receive_counts.data(),
      receive_starts.data(),
      MPI_DOUBLE,
      mpi
  );
  return received;
}

}  // namespace barreno
