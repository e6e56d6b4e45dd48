// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace barreno {

/// Names of a list that a preconditioner of Ifpack2 did not look at, and what else it knows. Most
/// of them do not mind what they do not know.
struct SmootherNames {
  std::vector<std::string> unread, known;
};

/// @param kind  in Ifpack2's own words: CHEBYSHEV, RILUK...
/// @throws std::exception of Ifpack2 if it has no such kind or refuses a value
SmootherNames smoother_names(const std::string& kind, const Teuchos::ParameterList& list);

}  // namespace barreno
