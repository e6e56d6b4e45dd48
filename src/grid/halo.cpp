// SPDX-License-Identifier: BSD-3-Clause
#include "grid/halo.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"

#include <Teuchos_OrdinalTraits.hpp>
#include <Tpetra_Distributor.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>

#include <algorithm>
#include <utility>

namespace barreno {
namespace {

using GlobalTile = long long;
using TileMap = Tpetra::Map<int, GlobalTile>;
using TileImport = Tpetra::Import<int, GlobalTile>;

/// Tiles of other ranks near one of ours, whether they are active or not.
std::vector<GlobalTile> touching_tiles(const Grid& grid, const std::vector<int>& owned) {
  const int me = grid.comm->getRank();
  std::vector<GlobalTile> touching;
  for (const int id : owned) {
    const TilePosition at = grid.box.position(id);
    for_each_neighbour(grid.patch, [&](int, int dx, int dy, int dz) {
      const TilePosition beside{{at[0] + dx, at[1] + dy, at[2] + dz}, at.level};
      if (!grid.box.has(beside)) return;
      const auto box_tile = static_cast<std::size_t>(grid.box.box_tile(beside));
      if (grid.owner[box_tile] != me) touching.push_back(grid.box.id(beside));
    });
  }
  std::sort(touching.begin(), touching.end());
  touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
  return touching;
}

ArrayView<int> copy_of(const Teuchos::ArrayView<const int>& values) {
  ArrayView<int> copy("tiles", static_cast<std::size_t>(values.size()));
  const auto host = Kokkos::create_mirror_view(copy);
  std::copy(values.begin(), values.end(), host.data());
  Kokkos::deep_copy(copy, host);
  return copy;
}

}  // namespace

struct HaloPlan {
  Teuchos::RCP<const TileMap> owned, ghosts;
  Teuchos::RCP<const TileImport> import;
  ArrayView<int> sent, received;         ///< local tiles, in the order of the messages
  ArrayView<double> outgoing, incoming;  ///< kept: the step allocates nothing
};

namespace {

/// The first `size` entries of a buffer that grows as it must.
ArrayView<double> room_in(ArrayView<double>& buffer, std::size_t size) {
  if (buffer.extent(0) < size) buffer = ArrayView<double>("halo", size);
  return Kokkos::subview(buffer, std::make_pair(std::size_t{0}, size));
}

}  // namespace

std::vector<int> build_halo(Grid& grid, const std::vector<int>& owned) {
  grid.halo.reset();
  if (grid.comm->getSize() == 1) return {};
  const auto invalid = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  auto plan = std::make_shared<HaloPlan>();
  const Teuchos::Array<GlobalTile> mine(owned.begin(), owned.end());
  plan->owned = Teuchos::rcp(new TileMap(invalid, mine(), 0, grid.comm));

  // The owner of a tile follows from its place, but only the owner knows whether it is active.
  std::vector<GlobalTile> touching = touching_tiles(grid, owned);
  Teuchos::Array<int> ranks(static_cast<int>(touching.size()));
  plan->owned->getRemoteIndexList(
      Teuchos::ArrayView<const GlobalTile>(touching.data(), static_cast<int>(touching.size())),
      ranks()
  );
  Teuchos::Array<GlobalTile> ghosts;
  for (std::size_t i = 0; i < touching.size(); ++i)
    if (ranks[static_cast<int>(i)] >= 0) ghosts.push_back(touching[i]);

  plan->ghosts = Teuchos::rcp(new TileMap(invalid, ghosts(), 0, grid.comm));
  plan->import = Teuchos::rcp(new TileImport(plan->owned, plan->ghosts));
  plan->sent = copy_of(plan->import->getExportLIDs());
  plan->received = copy_of(plan->import->getRemoteLIDs());
  grid.halo = plan;
  return {ghosts.begin(), ghosts.end()};
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
  plan.import->getDistributor().doPostsAndWaits(packed, row, incoming);
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
