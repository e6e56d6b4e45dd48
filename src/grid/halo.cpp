// SPDX-License-Identifier: BSD-3-Clause
#include "grid/halo.hpp"

#include "base/exchange.hpp"
#include "base/launch.hpp"
#include "base/region.hpp"
#include "base/view_of.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <mpi.h>

#include <algorithm>
#include <map>
#include <utility>

namespace barreno {

/// What goes to another rank and comes from it, in every exchange.
struct HaloNeighbour {
  int rank = 0;
  int sent = 0, received = 0;  ///< tiles
};

struct HaloPlan {
  std::vector<HaloNeighbour> neighbours;  ///< ascending
  ArrayView<int> sent;                    ///< local tiles, in the order of the messages
  ArrayView<int> received;                ///< likewise, counted among the ghosts
  ArrayView<double> outgoing, incoming;   ///< kept: the step allocates nothing
  std::vector<MPI_Request> requests;
};

namespace {

/// Those of exchange() are others.
constexpr int halo_tag = 4713;

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
      const int other = grid.owner[static_cast<std::size_t>(grid.box.box_tile(beside))];
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

MPI_Comm mpi_of(const Grid& grid) {
  return *dynamic_cast<const Teuchos::MpiComm<int>&>(*grid.comm).getRawMpiComm();
}

/// Sends and receives `row` doubles for each tile, from and into the host's memory.
void swap_rows(const Grid& grid, std::size_t row, double* outgoing, double* incoming) {
  HaloPlan& plan = *grid.halo;
  MPI_Comm comm = mpi_of(grid);
  std::size_t next = 0;
  for (const HaloNeighbour& other : plan.neighbours) {
    const int count = other.received * static_cast<int>(row);
    MPI_Irecv(incoming, count, MPI_DOUBLE, other.rank, halo_tag, comm, &plan.requests[next++]);
    incoming += count;
  }
  for (const HaloNeighbour& other : plan.neighbours) {
    const int count = other.sent * static_cast<int>(row);
    MPI_Isend(outgoing, count, MPI_DOUBLE, other.rank, halo_tag, comm, &plan.requests[next++]);
    outgoing += count;
  }
  MPI_Waitall(static_cast<int>(next), plan.requests.data(), MPI_STATUSES_IGNORE);
}

}  // namespace

/// Both sides of a border find the same tiles from what they tell each other: what one sends is
/// what touches the other's, and so what the other receives.
std::vector<int> build_halo(Grid& grid, const std::vector<int>& owned) {
  grid.halo.reset();
  if (grid.comm->getSize() == 1) return {};
  const TilesOfRank told = tiles_at_borders(grid, owned);
  auto plan = std::make_shared<HaloPlan>();
  std::vector<int> sent, received;
  for (const auto& [rank, theirs] : tell_neighbours(grid, told)) {
    const auto ours = told.find(rank);
    if (ours == told.end()) continue;
    const std::vector<int> out = touching(grid, ours->second, theirs);
    const std::vector<int> in = touching(grid, theirs, ours->second);
    if (out.empty()) continue;  // then so is `in`
    plan->neighbours.push_back({rank, static_cast<int>(out.size()), static_cast<int>(in.size())});
    sent.insert(sent.end(), out.begin(), out.end());
    received.insert(received.end(), in.begin(), in.end());
  }
  std::vector<int> ghosts = received;
  std::sort(ghosts.begin(), ghosts.end());
  plan->sent = view_of("sent_tiles", places_in(owned, sent));
  plan->received = view_of("received_tiles", places_in(ghosts, received));
  plan->requests.assign(2 * plan->neighbours.size(), MPI_REQUEST_NULL);
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
  // MPI works in the host's memory, which these are where kernels do too.
  const auto from_here = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), outgoing);
  const auto from_others = Kokkos::create_mirror_view(incoming);
  swap_rows(grid, row, from_here.data(), from_others.data());
  Kokkos::deep_copy(incoming, from_others);
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
