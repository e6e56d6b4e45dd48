// SPDX-License-Identifier: BSD-3-Clause
#include "grid/halo.hpp"

#include "base/exchange.hpp"
#include "base/launch.hpp"
#include "base/region.hpp"
#include "base/view_of.hpp"

#include <Tpetra_Distributor.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace barreno {

struct HaloPlan {
  Teuchos::RCP<Tpetra::Distributor> distributor;
  ArrayView<int> sent;                   ///< local tiles, in the order of the messages
  ArrayView<int> received;               ///< likewise, counted among the ghosts
  ArrayView<double> outgoing, incoming;  ///< kept: the step allocates nothing
};

namespace {

/// Tiles by the other rank that they have to do with, each list ascending.
using TilesOfRank = std::map<int, std::vector<int>>;

/// visit(tile) for every place of a tile's level whose patch overlaps that of the tile.
template <class Visitor>
void for_each_touching(const Grid& grid, int id, Visitor&& visit) {
  const TilePosition at = grid.box.position(id);
  for_each_neighbour(grid.patch, [&](int, int dx, int dy, int dz) {
    const TilePosition beside{{at[0] + dx, at[1] + dy, at[2] + dz}, at.level};
    if (grid.box.has(beside)) visit(beside);
  });
}

/// Own active tiles that touch a place of another rank, whether its tile is active or not: the
/// owner of a place is known to all, but only the owner knows whether it has a tile there.
TilesOfRank tiles_at_borders(const Grid& grid, const std::vector<int>& owned) {
  const int me = grid.comm->getRank();
  TilesOfRank at_border;
  for (const int id : owned)
    for_each_touching(grid, id, [&](const TilePosition& beside) {
      const int other = owner_of(grid, grid.box.box_tile(beside));
      if (other == me) return;
      std::vector<int>& tiles = at_border[other];
      if (tiles.empty() || tiles.back() != id) tiles.push_back(id);
    });
  return at_border;
}

/// Tells each rank which tiles this one has at their border. @return what the others have there
TilesOfRank tell_neighbours(const Grid& grid, const TilesOfRank& told) {
  std::vector<std::vector<double>> outgoing(static_cast<std::size_t>(grid.comm->getSize()));
  for (const auto& [rank, tiles] : told) {
    std::vector<double>& message = outgoing[static_cast<std::size_t>(rank)];
    message = {static_cast<double>(grid.comm->getRank()), static_cast<double>(tiles.size())};
    message.insert(message.end(), tiles.begin(), tiles.end());
  }
  const std::vector<double> received = exchange_rows(*grid.comm, outgoing);
  TilesOfRank heard;
  for (auto next = received.begin(); next != received.end();) {
    std::vector<int>& tiles = heard[static_cast<int>(*next++)];
    const auto count = static_cast<std::ptrdiff_t>(*next++);
    tiles.assign(next, next + count);
    next += count;
  }
  return heard;
}

/// Those of `some` that touch one of `others`.
std::vector<int> touching(
    const Grid& grid, const std::vector<int>& some, const std::vector<int>& others
) {
  std::vector<int> found;
  for (const int id : some) {
    bool touches = false;
    for_each_touching(grid, id, [&](const TilePosition& beside) {
      touches = touches || std::binary_search(others.begin(), others.end(), grid.box.id(beside));
    });
    if (touches) found.push_back(id);
  }
  return found;
}

/// The places of tiles in an ascending list that has them all.
std::vector<int> places_in(const std::vector<int>& list, const std::vector<int>& tiles) {
  std::vector<int> places;
  places.reserve(tiles.size());
  for (const int id : tiles)
    places.push_back(static_cast<int>(std::lower_bound(list.begin(), list.end(), id) - list.begin())
    );
  return places;
}

/// The first `size` entries of a buffer that grows as it must.
ArrayView<double> room_in(ArrayView<double>& buffer, std::size_t size) {
  if (buffer.extent(0) < size) buffer = ArrayView<double>("halo", size);
  return Kokkos::subview(buffer, std::make_pair(std::size_t{0}, size));
}

}  // namespace

/// Both sides of a border find the same tiles from what they tell each other: what one sends is
/// what touches the other's, and so what the other receives.
std::vector<int> build_halo(Grid& grid, const std::vector<int>& owned) {
  grid.halo.reset();
  if (grid.comm->getSize() == 1) return {};
  const TilesOfRank told = tiles_at_borders(grid, owned);
  std::vector<int> sent, received, to, from;
  for (const auto& [rank, theirs] : tell_neighbours(grid, told)) {
    const auto ours = told.find(rank);
    if (ours == told.end()) continue;
    const std::vector<int> out = touching(grid, ours->second, theirs);
    const std::vector<int> in = touching(grid, theirs, ours->second);
    if (out.empty()) continue;  // then so is `in`
    sent.insert(sent.end(), out.begin(), out.end());
    received.insert(received.end(), in.begin(), in.end());
    to.insert(to.end(), out.size(), rank);
    from.insert(from.end(), in.size(), rank);
  }
  std::vector<int> ghosts = received;
  std::sort(ghosts.begin(), ghosts.end());
  auto plan = std::make_shared<HaloPlan>();
  plan->distributor = Teuchos::rcp(new Tpetra::Distributor(grid.comm));
  plan->distributor->createFromSendsAndRecvs(to, from);
  plan->sent = view_of("sent_tiles", places_in(owned, sent));
  plan->received = view_of("received_tiles", places_in(ghosts, received));
  grid.halo = plan;
  return ghosts;
}

void exchange_halo(const Grid& grid, const ArrayView<double>& sums, int width) {
  if (!grid.halo) return;
  const Region region("exchange_halo");
  HaloPlan& plan = *grid.halo;
  const auto row = static_cast<std::size_t>(width);
  const ArrayView<int> sent = plan.sent, received = plan.received;
  const ArrayView<double> outgoing = room_in(plan.outgoing, sent.extent(0) * row);
  const ArrayView<double> incoming = room_in(plan.incoming, received.extent(0) * row);
  const std::size_t first_ghost = static_cast<std::size_t>(grid.active) * row;
  launch(
      "pack_halo",
      range(static_cast<int>(sent.extent(0))),
      KOKKOS_LAMBDA(const int i) {
        const double* const from = &sums(static_cast<std::size_t>(sent(i)) * row);
        double* const to = &outgoing(static_cast<std::size_t>(i) * row);
        for (std::size_t c = 0; c < row; ++c) to[c] = from[c];
      }
  );
  const ArrayView<const double> packed = outgoing;
  plan.distributor->doPostsAndWaits(packed, row, incoming);
  launch(
      "unpack_halo",
      range(static_cast<int>(received.extent(0))),
      KOKKOS_LAMBDA(const int i) {
        const double* const from = &incoming(static_cast<std::size_t>(i) * row);
        double* const to = &sums(first_ghost + static_cast<std::size_t>(received(i)) * row);
        for (std::size_t c = 0; c < row; ++c) to[c] = from[c];
      }
  );
}

}  // namespace barreno
