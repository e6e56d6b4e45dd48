// SPDX-License-Identifier: BSD-3-Clause
#include "pore_flow/linear_system.hpp"

#include "base/gather.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace barreno {

double flow_over_storage(const LinearSystem& system, const Teuchos::Comm<int>& comm) {
  constexpr double round_off = 1e-12;
  std::array<double, 1> most{0.0};
  for (std::size_t i = 0; i < system.ids.size(); ++i) {
    double flow = 0.0, diagonal = 0.0;
    for (std::size_t k = system.begin[i]; k < system.begin[i + 1]; ++k)
      (system.column[k] == system.ids[i] ? diagonal : flow) += std::fabs(system.value[k]);
    const double stored = diagonal - flow;
    if (stored > round_off * diagonal) most[0] = std::max(most[0], flow / stored);
  }
  max_over_ranks(comm, most);
  return most[0];
}

}  // namespace barreno
