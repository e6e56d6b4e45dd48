// SPDX-License-Identifier: BSD-3-Clause
#include "pore_flow/pore_halo.hpp"

#include "base/region.hpp"

#include <Teuchos_OrdinalTraits.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <unordered_map>

namespace barreno {
namespace {

using Map = Tpetra::Map<int, long long>;
using Import = Tpetra::Import<int, long long>;
using Vectors = Tpetra::MultiVector<double, int, long long>;

static_assert(std::is_trivially_copyable_v<PoreCell> && sizeof(PoreCell) % sizeof(double) == 0);
constexpr std::size_t cell_values = sizeof(PoreCell) / sizeof(double);

/// Id of the cell beyond a face, or -1 at the end of the box.
long long id_beyond(const Grid& grid, long long id, std::size_t face) {
  const std::array<int, 3> at = place_of_cell(grid, id);
  const std::size_t d = face / 2;
  const int moved = at[d] + (face % 2 == 0 ? -1 : 1);
  if (moved < 0 || moved >= grid.cells[d]) return -1;
  long long stride = 1;
  for (std::size_t e = 0; e < d; ++e) stride *= grid.cells[e];
  return id + (moved - at[d]) * stride;
}

int owner_of_cell(const Grid& grid, long long id) {
  const std::array<int, 3> at = place_of_cell(grid, id);
  TilePosition tile;
  for (std::size_t d = 0; d < static_cast<std::size_t>(grid.patch.dimensions); ++d)
    tile.along[d] = at[d] >> grid.patch.tile_bits;
  return owner_of(grid, grid.box.id(tile));
}

template <class Visitor>
void for_each_face(const Grid& grid, Visitor&& visit) {
  for (std::size_t face = 0; face < 2 * static_cast<std::size_t>(grid.patch.dimensions); ++face)
    visit(face);
}

/// Cells of other ranks next to own ones, whether there is anything in them or not.
std::vector<long long> touching_cells(const Grid& grid, const PoreCells& cells) {
  const int me = grid.comm->getRank();
  std::vector<long long> touching;
  for (const long long id : cells.ids)
    for_each_face(grid, [&](std::size_t face) {
      const long long beyond = id_beyond(grid, id, face);
      if (beyond >= 0 && owner_of_cell(grid, beyond) != me) touching.push_back(beyond);
    });
  std::sort(touching.begin(), touching.end());
  touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
  return touching;
}

void find_neighbours(const Grid& grid, PoreCells& cells) {
  std::unordered_map<long long, int> index;
  for (std::size_t i = 0; i < cells.ids.size(); ++i) index[cells.ids[i]] = static_cast<int>(i);
  std::array<int, 6> none{};
  none.fill(-1);
  cells.next.assign(static_cast<std::size_t>(cells.own), none);
  for (std::size_t i = 0; i < cells.next.size(); ++i)
    for_each_face(grid, [&](std::size_t face) {
      const auto found = index.find(id_beyond(grid, cells.ids[i], face));
      if (found != index.end()) cells.next[i][face] = found->second;
    });
}

}  // namespace

struct PoreHalo {
  Teuchos::RCP<const Map> own, ghosts;
  Teuchos::RCP<const Import> import;  ///< null on one rank
};

std::shared_ptr<PoreHalo> build_pore_halo(const Grid& grid, PoreCells& cells) {
  const Region region("build_pore_halo");
  auto halo = std::make_shared<PoreHalo>();
  cells.ids.resize(static_cast<std::size_t>(cells.own));
  if (grid.comm->getSize() > 1) {
    const auto invalid = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
    halo->own = Teuchos::rcp(new Map(
        invalid, Teuchos::ArrayView<const long long>(cells.ids.data(), cells.own), 0, grid.comm
    ));
    const std::vector<long long> touching = touching_cells(grid, cells);
    const auto count = static_cast<int>(touching.size());
    Teuchos::Array<int> ranks(count);
    halo->own->getRemoteIndexList(
        Teuchos::ArrayView<const long long>(touching.data(), count), ranks()
    );
    for (std::size_t i = 0; i < touching.size(); ++i)
      if (ranks[static_cast<int>(i)] >= 0) cells.ids.push_back(touching[i]);
    const auto others = static_cast<int>(cells.ids.size()) - cells.own;
    halo->ghosts = Teuchos::rcp(new Map(
        invalid,
        Teuchos::ArrayView<const long long>(cells.ids.data() + cells.own, others),
        0,
        grid.comm
    ));
    halo->import = Teuchos::rcp(new Import(halo->own, halo->ghosts));
  }
  find_neighbours(grid, cells);
  return halo;
}

void exchange_pore_cells(const PoreHalo& halo, PoreCells& cells) {
  if (halo.import.is_null()) return;
  const Region region("exchange_pore_cells");
  Vectors from(halo.own, cell_values), to(halo.ghosts, cell_values);
  for (std::size_t c = 0; c < cell_values; ++c) {
    const auto column = from.getDataNonConst(c);
    for (int i = 0; i < cells.own; ++i)
      std::memcpy(
          &column[i],
          reinterpret_cast<const char*>(&cells.cells[static_cast<std::size_t>(i)]) +
              c * sizeof(double),
          sizeof(double)
      );
  }
  to.doImport(from, *halo.import, Tpetra::INSERT);
  cells.cells.resize(cells.ids.size());
  for (std::size_t c = 0; c < cell_values; ++c) {
    const auto column = to.getData(c);
    for (auto i = static_cast<std::size_t>(cells.own); i < cells.cells.size(); ++i)
      std::memcpy(
          reinterpret_cast<char*>(&cells.cells[i]) + c * sizeof(double),
          &column[static_cast<int>(i) - cells.own],
          sizeof(double)
      );
  }
}

void exchange_pore_values(const PoreHalo& halo, std::vector<double>& values) {
  if (halo.import.is_null()) return;
  const Region region("exchange_pore_values");
  Vectors from(halo.own, 1), to(halo.ghosts, 1);
  const auto out = from.getDataNonConst(0);
  values.resize(static_cast<std::size_t>(out.size()));
  std::copy(values.begin(), values.end(), out.begin());
  to.doImport(from, *halo.import, Tpetra::INSERT);
  const auto in = to.getData(0);
  values.insert(values.end(), in.begin(), in.end());
}

}  // namespace barreno
