// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Teuchos_Comm.hpp>

#include <vector>

namespace barreno {

/// Send rows of doubles to the ranks named; any distance in one call. Collective.
///
/// @param outgoing  one buffer per rank
/// @return what the ranks sent to this one, in rank order, itself included
std::vector<double> exchange_rows(
    const Teuchos::Comm<int>& comm, const std::vector<std::vector<double>>& outgoing
);

}  // namespace barreno
