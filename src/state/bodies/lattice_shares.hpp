// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/bodies/body_particles.hpp"

#include <functional>
#include <vector>

namespace barreno {

/// Makes the particles of bodies that are cut from a lattice: every rank looks at an equal share of
/// the cells, makes the particles in them and sends them to the owners of their tiles, many bodies
/// at a time but no more than a limited number of cells. So they do not come in the order of their
/// ids, unless there is one rank; ids count from 0 over a body.
class LatticeShares {
public:
  /// visit(body, particle), once for each that is in this rank's tiles.
  using Visit = std::function<void(std::size_t, const NewParticle&)>;
  explicit LatticeShares(const Grid& grid, Visit visit);

  /// This rank's share of a body. Collective.
  /// @param index   what `visit` is told
  /// @param before  particles in the shares of lower ranks
  void make(const GridSpec& spec, const BodySpec& body, std::size_t index, long long before);
  /// All that was made is where it belongs. Collective.
  void finish();

private:
  void send(std::size_t index, const NewParticle& particle);

  const Grid& grid_;
  CellLattice cells_;
  Visit visit_;
  std::vector<std::vector<double>> by_rank_;  ///< rows on their way
  long long cells_looked_at_ = 0;             ///< since rows were sent, by the rank with the most
};

}  // namespace barreno
