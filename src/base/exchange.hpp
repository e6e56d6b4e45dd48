// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Teuchos_Comm.hpp>

#include <vector>

namespace barreno {

/// Values from every rank to every rank in one call. Collective. Messages go to those ranks alone
/// that get something, and nobody is told how many to expect: sends are synchronous, and a barrier
/// that does not block ends when all have been received. (T. Hoefler, C. Siebert, A. Lumsdaine,
/// Scalable communication protocols for dynamic sparse data exchange, PPoPP 2010)
///
/// @param send    those for rank 0, then those for rank 1, and so on
/// @param counts  how many of them each rank gets
/// @return what was sent to this rank, in rank order
std::vector<double> exchange(
    const Teuchos::Comm<int>& comm, const std::vector<double>& send, const std::vector<int>& counts
);

/// The same with a buffer for each rank.
std::vector<double> exchange_rows(
    const Teuchos::Comm<int>& comm, const std::vector<std::vector<double>>& outgoing
);

}  // namespace barreno
