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
  /// Rows of an array that ranks exchange: those of tiles, or of nodes, tile * patch.size + slot.
  struct Rows {
    Teuchos::RCP<Tpetra::Distributor> distributor;
    ArrayView<int> sent;                   ///< own rows, in the order of the messages
    ArrayView<int> received;               ///< likewise, counted from the first of the ghosts
    ArrayView<double> outgoing, incoming;  ///< kept: the step allocates nothing
  };
  Rows tiles, nodes;
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

/// The place of a tile in an ascending list that has it.
int place_in(const std::vector<int>& list, int tile) {
  return static_cast<int>(std::lower_bound(list.begin(), list.end(), tile) - list.begin());
}

/// Slots of a tile's patch that patches of the other side hold too, ascending; none if none of them
/// touches it.
///
/// @param readers  the other side's tiles at the border, ascending
std::vector<int> shared_slots(const Grid& grid, int id, const std::vector<int>& readers) {
  const TilePosition at = grid.box.position(id);
  std::vector<char> shared(static_cast<std::size_t>(grid.patch.size), 0);
  for_each_touching(grid, id, [&](const TilePosition& beside) {
    if (!std::binary_search(readers.begin(), readers.end(), grid.box.id(beside))) return;
    const int offset[3] = {beside[0] - at[0], beside[1] - at[1], beside[2] - at[2]};
    for_each_shared_slot(grid.patch, offset, [&](int slot) {
      shared[static_cast<std::size_t>(slot)] = 1;
    });
  });
  std::vector<int> slots;
  for (int slot = 0; slot < grid.patch.size; ++slot)
    if (shared[static_cast<std::size_t>(slot)] != 0) slots.push_back(slot);
  return slots;
}

/// A tile at a border, and its nodes that the other side holds too.
struct SharedTile {
  int id = 0;
  std::vector<int> slots;
};

/// Those of `tiles` that touch one of `readers`, in their order.
std::vector<SharedTile> shared_tiles(
    const Grid& grid, const std::vector<int>& tiles, const std::vector<int>& readers
) {
  std::vector<SharedTile> shared;
  for (const int id : tiles) {
    std::vector<int> slots = shared_slots(grid, id, readers);
    if (!slots.empty()) shared.push_back({id, std::move(slots)});
  }
  return shared;
}

/// Tiles and nodes that go to other ranks, or come from them, in the order of the messages.
struct Traffic {
  std::vector<int> tiles, tile_ranks;
  std::vector<int> nodes, node_ranks;  ///< node: place of its tile * patch.size + slot

  /// @param places  the list, ascending, in which a tile's place is that of its row
  void add(
      const Patch& patch,
      int rank,
      const std::vector<SharedTile>& shared,
      const std::vector<int>& places
  ) {
    for (const SharedTile& tile : shared) {
      const int place = place_in(places, tile.id);
      tiles.push_back(place);
      for (const int slot : tile.slots) nodes.push_back(place * patch.size + slot);
    }
    tile_ranks.resize(tiles.size(), rank);
    node_ranks.resize(nodes.size(), rank);
  }
};

HaloPlan::Rows plan_rows(
    const Grid& grid,
    const std::vector<int>& sent,
    const std::vector<int>& to,
    const std::vector<int>& received,
    const std::vector<int>& from
) {
  HaloPlan::Rows plan;
  plan.distributor = Teuchos::rcp(new Tpetra::Distributor(grid.comm));
  plan.distributor->createFromSendsAndRecvs(to, from);
  plan.sent = view_of("sent_rows", sent);
  plan.received = view_of("received_rows", received);
  return plan;
}

ArrayView<unsigned char> marks_of(const std::vector<int>& nodes, std::size_t size) {
  std::vector<unsigned char> marks(size, 0);
  for (const int node : nodes) marks[static_cast<std::size_t>(node)] = 1;
  return view_of("fetched", marks);
}

/// The first `size` entries of a buffer that grows as it must.
ArrayView<double> room_in(ArrayView<double>& buffer, std::size_t size) {
  if (buffer.extent(0) < size) buffer = ArrayView<double>("halo", size);
  return Kokkos::subview(buffer, std::make_pair(std::size_t{0}, size));
}

/// @param ghosts  the first row of the ghosts
void exchange(
    HaloPlan::Rows& plan, const ArrayView<double>& values, std::size_t ghosts, int width
) {
  const auto row = static_cast<std::size_t>(width);
  const ArrayView<int> sent = plan.sent, received = plan.received;
  const ArrayView<double> outgoing = room_in(plan.outgoing, sent.extent(0) * row);
  const ArrayView<double> incoming = room_in(plan.incoming, received.extent(0) * row);
  const std::size_t first_ghost = ghosts * row;
  launch(
      "pack_halo",
      range(static_cast<int>(sent.extent(0))),
      KOKKOS_LAMBDA(const int i) {
        const double* const from = &values(static_cast<std::size_t>(sent(i)) * row);
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
        double* const to = &values(first_ghost + static_cast<std::size_t>(received(i)) * row);
        for (std::size_t c = 0; c < row; ++c) to[c] = from[c];
      }
  );
}

/// The tiles that come from each rank, and those that go to it.
struct Border {
  int rank = 0;
  std::vector<SharedTile> sent, received;  ///< ascending
};

std::vector<Border> borders_of(
    const Grid& grid, const TilesOfRank& told, const TilesOfRank& heard
) {
  std::vector<Border> borders;
  for (const auto& [rank, theirs] : heard) {
    const auto ours = told.find(rank);
    if (ours == told.end()) continue;
    Border border{
        rank, shared_tiles(grid, ours->second, theirs), shared_tiles(grid, theirs, ours->second)};
    if (!border.sent.empty()) borders.push_back(std::move(border));  // else none is received
  }
  return borders;
}

}  // namespace

/// Both sides of a border find the same tiles and nodes from what they tell each other: what one
/// sends is what the other's tiles hold too, and so what the other receives.
std::vector<int> build_halo(Grid& grid, const std::vector<int>& owned) {
  grid.halo.reset();
  grid.fetched = {};
  if (grid.comm->getSize() == 1) return {};
  const TilesOfRank told = tiles_at_borders(grid, owned);
  const std::vector<Border> borders = borders_of(grid, told, tell_neighbours(grid, told));
  std::vector<int> ghosts;
  for (const Border& border : borders)
    for (const SharedTile& tile : border.received) ghosts.push_back(tile.id);
  std::sort(ghosts.begin(), ghosts.end());
  Traffic out, in;
  for (const Border& border : borders) {
    out.add(grid.patch, border.rank, border.sent, owned);
    in.add(grid.patch, border.rank, border.received, ghosts);
  }
  grid.halo = std::make_shared<HaloPlan>(HaloPlan{
      plan_rows(grid, out.tiles, out.tile_ranks, in.tiles, in.tile_ranks),
      plan_rows(grid, out.nodes, out.node_ranks, in.nodes, in.node_ranks)});
  grid.fetched = marks_of(in.nodes, ghosts.size() * static_cast<std::size_t>(grid.patch.size));
  return ghosts;
}

void exchange_halo(const Grid& grid, const ArrayView<double>& sums, int components) {
  if (!grid.halo) return;
  const Region region("exchange_halo");
  const std::size_t active =
      static_cast<std::size_t>(grid.active) * static_cast<std::size_t>(grid.patch.size);
  exchange(grid.halo->nodes, sums, active, components);
}

void exchange_tiles(const Grid& grid, const ArrayView<double>& values, int width) {
  if (!grid.halo) return;
  const Region region("exchange_tiles");
  exchange(grid.halo->tiles, values, static_cast<std::size_t>(grid.active), width);
}

}  // namespace barreno
