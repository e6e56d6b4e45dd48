// SPDX-License-Identifier: BSD-3-Clause
#include "state/bodies/lattice_shares.hpp"

#include "base/exchange.hpp"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

namespace barreno {
namespace {

/// Cells that a rank looks at between two exchanges: what it makes of them is kept until then.
constexpr long long cells_at_once = 1 << 17;

/// A particle on its way: body, id, place, half sizes, volume, sides.
constexpr std::size_t row_width = 10;

double id_bits(ParticleId id) {
  double bits = 0.0;
  static_assert(sizeof bits == sizeof id);
  std::memcpy(&bits, &id, sizeof id);
  return bits;
}

NewParticle unpacked(const double* row) {
  NewParticle particle;
  std::memcpy(&particle.id, row + 1, sizeof particle.id);
  std::copy_n(row + 2, 3, particle.x.begin());
  std::copy_n(row + 5, 3, particle.half.begin());
  particle.volume = row[8];
  particle.loaded_sides = static_cast<unsigned>(row[9]);
  return particle;
}

}  // namespace

LatticeShares::LatticeShares(const Grid& grid, Visit visit)
    : grid_(grid),
      cells_(grid),
      visit_(std::move(visit)),
      by_rank_(static_cast<std::size_t>(grid.comm->getSize())) {}

void LatticeShares::send(std::size_t index, const NewParticle& particle) {
  const Cell cell = cells_.cell_at([&](int d) { return particle.x[static_cast<std::size_t>(d)]; });
  const int owner = owner_of(grid_, cell.box_tile);
  std::vector<double>& rows = by_rank_[static_cast<std::size_t>(owner)];
  rows.push_back(static_cast<double>(index));
  rows.push_back(id_bits(particle.id));
  rows.insert(rows.end(), particle.x.begin(), particle.x.end());
  rows.insert(rows.end(), particle.half.begin(), particle.half.end());
  rows.push_back(particle.volume);
  rows.push_back(static_cast<double>(particle.loaded_sides));
}

void LatticeShares::make(
    const GridSpec& spec, const BodySpec& body, std::size_t index, long long before
) {
  const Lattice lattice = body_lattice(spec, body);
  const int ranks = grid_.comm->getSize();
  const CellSpan share = share_of_cells(lattice, grid_.comm->getRank(), ranks);
  if (ranks == 1) {
    const auto visit = [&](const NewParticle& particle) { visit_(index, particle); };
    return for_each_lattice_particle(spec, body, share, 0, visit);
  }
  // That of rank 0 is the largest: by it all ranks come to the same exchanges.
  const long long largest = share_of_cells(lattice, 0, ranks).end;
  ParticleId next = before;
  for (long long at = 0; at < largest;) {
    const long long end = std::min(largest, at + cells_at_once - cells_looked_at_);
    const CellSpan part{
        std::min(share.begin + at, share.end), std::min(share.begin + end, share.end)};
    for_each_lattice_particle(spec, body, part, next, [&](const NewParticle& particle) {
      send(index, particle);
      next = particle.id + 1;
    });
    cells_looked_at_ += end - at;
    at = end;
    if (cells_looked_at_ == cells_at_once) finish();
  }
}

void LatticeShares::finish() {
  if (cells_looked_at_ == 0) return;
  cells_looked_at_ = 0;
  const std::vector<double> rows = exchange_rows(*grid_.comm, by_rank_);
  for (std::vector<double>& sent : by_rank_) sent.clear();
  for (std::size_t k = 0; k < rows.size(); k += row_width)
    visit_(static_cast<std::size_t>(rows[k]), unpacked(&rows[k]));
}

}  // namespace barreno
