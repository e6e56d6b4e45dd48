// SPDX-License-Identifier: BSD-3-Clause
#include "grid/tile_directory.hpp"

#include "base/launch.hpp"
#include "base/view_of.hpp"

#include <algorithm>

namespace barreno {
namespace {

std::vector<int> pages_of(const std::vector<int>& tiles) {
  std::vector<int> pages;
  pages.reserve(tiles.size());
  for (const int tile : tiles) pages.push_back(TileDirectory::page(tile));
  std::sort(pages.begin(), pages.end());
  pages.erase(std::unique(pages.begin(), pages.end()), pages.end());
  return pages;
}

/// Page zero holds no tile; behind it stand those in use.
void begin_pages(const TileDirectory& directory, int first, int step) {
  const ArrayView<int> begin = directory.begin, used = directory.used;
  launch(
      "begin_pages",
      range(static_cast<int>(used.extent(0))),
      KOKKOS_LAMBDA(const int i) { begin(used(i)) = first + i * step; }
  );
}

void make_entries(std::size_t pages, TileDirectory& directory) {
  constexpr auto size = static_cast<std::size_t>(TileDirectory::page_size);
  directory.entry = ArrayView<int>("directory_entry", (pages + 1) * size);
  Kokkos::deep_copy(directory.entry, -1);
}

}  // namespace

TileDirectory make_tile_directory(int places) {
  TileDirectory directory;
  const int pages = TileDirectory::page(places) + 1;
  directory.begin = ArrayView<int>("directory_begin", static_cast<std::size_t>(pages));
  make_entries(0, directory);
  return directory;
}

void list_tiles(const std::vector<int>& tiles, TileDirectory& directory) {
  begin_pages(directory, 0, 0);
  const std::vector<int> pages = pages_of(tiles);
  directory.used = view_of("directory_used", pages);
  make_entries(pages.size(), directory);
  begin_pages(directory, TileDirectory::page_size, TileDirectory::page_size);
  const ArrayView<int> tile = view_of("listed_tiles", tiles);
  const ArrayView<int> begin = directory.begin, entry = directory.entry;
  launch(
      "list_tiles",
      range(static_cast<int>(tiles.size())),
      KOKKOS_LAMBDA(const int t) {
        const int id = tile(t);
        entry(begin(TileDirectory::page(id)) + TileDirectory::in_page(id)) = t;
      }
  );
}

}  // namespace barreno
