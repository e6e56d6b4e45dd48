// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Teuchos_Comm.hpp>

#include <vector>

namespace barreno {

/// Values from every rank to every rank in one call. Collective.
///
/// @param send    those for rank 0, then those for rank 1, and so on
/// @param counts  how many of them each rank gets
/// @return what was sent to this rank, in rank order
std::vector<double> exchange(
    const Teuchos::Comm<int>& comm, const std::vector<double>& send, const std::vector<int>& counts
);

}  // namespace barreno
