// SPDX-License-Identifier: BSD-3-Clause
#include "base/exchange.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <mpi.h>

namespace barreno {
namespace {

/// Where each rank's part begins, and the number of all.
std::vector<int> begins_of(const std::vector<int>& counts) {
  std::vector<int> begins(1, 0);
  for (const int count : counts) begins.push_back(begins.back() + count);
  return begins;
}

}  // namespace

std::vector<double> exchange(
    const Teuchos::Comm<int>& comm, const std::vector<double>& send, const std::vector<int>& counts
) {
  MPI_Comm mpi = *dynamic_cast<const Teuchos::MpiComm<int>&>(comm).getRawMpiComm();
  std::vector<int> arriving(counts.size());
  MPI_Alltoall(counts.data(), 1, MPI_INT, arriving.data(), 1, MPI_INT, mpi);
  const std::vector<int> from = begins_of(counts), to = begins_of(arriving);
  std::vector<double> received(static_cast<std::size_t>(to.back()));
  MPI_Alltoallv(
      send.data(),
      counts.data(),
      from.data(),
      MPI_DOUBLE,
      received.data(),
      arriving.data(),
      to.data(),
      MPI_DOUBLE,
      mpi
  );
  return received;
}

}  // namespace barreno
