// SPDX-License-Identifier: BSD-3-Clause
#include "step/nodes/sum_halos.hpp"

#include "grid/halo.hpp"
#include "step/boundary/mirror_nodes.hpp"
#include "step/nodes/restrict_sums.hpp"

namespace barreno {

void sum_halos(const SymmetryPlanes& symmetry, const Grid& grid, std::vector<Nodes>& fields) {
  for (Nodes& nodes : fields) {
    mirror_sums(symmetry, grid, nodes);
    restrict_sums(grid, nodes);
  }
  for (const Nodes& nodes : fields) exchange_halo(grid, nodes.sums, sum_components);
}

}  // namespace barreno
