// SPDX-License-Identifier: BSD-3-Clause
#include "grid/halo.hpp"

#include "base/region.hpp"

#include <Teuchos_OrdinalTraits.hpp>
#include <Tpetra_Distributor.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>

#include <algorithm>
#include <cstring>

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

}  // namespace

struct HaloPlan {
  Teuchos::RCP<const TileMap> owned, ghosts;
  Teuchos::RCP<const TileImport> import;
  Teuchos::Array<double> outgoing, incoming;  ///< kept: the step allocates nothing
};

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
  grid.halo = plan;
  return {ghosts.begin(), ghosts.end()};
}

void exchange_halo(const Grid& grid, const ArrayView<double>& sums, int width) {
  if (!grid.halo) return;
  const Region region("exchange_halo");
  HaloPlan& plan = *grid.halo;
  const auto exports = plan.import->getExportLIDs();
  const auto remotes = plan.import->getRemoteLIDs();
  const auto bytes = static_cast<std::size_t>(width) * sizeof(double);
  const auto row = static_cast<std::size_t>(width);
  plan.outgoing.resize(exports.size() * width);
  plan.incoming.resize(remotes.size() * width);
  for (Teuchos_Ordinal i = 0; i < exports.size(); ++i)
    std::memcpy(
        plan.outgoing.getRawPtr() + i * width,
        sums.data() + static_cast<std::size_t>(exports[i]) * row,
        bytes
    );
  plan.import->getDistributor().doPostsAndWaits(
      plan.outgoing().getConst(), static_cast<std::size_t>(width), plan.incoming()
  );
  for (Teuchos_Ordinal i = 0; i < remotes.size(); ++i)
    std::memcpy(
        sums.data() + static_cast<std::size_t>(grid.active + remotes[i]) * row,
        plan.incoming.getRawPtr() + i * width,
        bytes
    );
}

}  // namespace barreno
