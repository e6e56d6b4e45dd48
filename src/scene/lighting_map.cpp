// SPDX-License-Identifier: BSD-3-Clause
#include "scene/lighting_map.hpp"

#include "base/work_counts.hpp"
#include "geometry/piece.hpp"
#include "scene/geometry.hpp"
#include "scene/lighting.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace barreno {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// visit(cell) for a cell and those around it.
template <class Index, class Visit>
void for_each_around(const Index& own, std::size_t dimension, Visit&& visit) {
  const int deep = dimension == 3 ? 1 : 0;
  Index at{};
  for (at[2] = own[2] - deep; at[2] <= own[2] + deep; ++at[2])
    for (at[1] = own[1] - 1; at[1] <= own[1] + 1; ++at[1])
      for (at[0] = own[0] - 1; at[0] <= own[0] + 1; ++at[0]) visit(at);
}

}  // namespace

LightingMap::LightingMap(
    const GridSpec& grid, const std::vector<Shape>& shapes, const DetonationSpec& detonation
)
    : grid_(grid),
      detonation_(detonation),
      dimension_(static_cast<std::size_t>(dimensions(grid.mode))),
      size_(
          grid.cell_size / (grid.mode == Mode::three_dimensional ? parts_in_space : parts_in_plane)
      ) {
  place_table(shapes);
  mark_explosive(shapes);
  march();
}

/// The cells around all shapes, and one more on every side.
void LightingMap::place_table(const std::vector<Shape>& shapes) {
  std::size_t cells = 1;
  for (std::size_t d = 0; d < dimension_; ++d) {
    double low = infinite, high = -infinite;
    for (const Shape& shape : shapes) {
      const Box box = box_around(shape, grid_);
      low = std::min(low, box.lower[d]);
      high = std::max(high, box.upper[d]);
    }
    first_[d] = static_cast<int>(std::floor((low - grid_.lower[d]) / size_)) - 1;
    const int last = static_cast<int>(std::ceil((high - grid_.lower[d]) / size_));
    count_[d] = last - first_[d] + 1;
    cells *= static_cast<std::size_t>(count_[d]);
  }
  explosive_.assign(cells, 0);
  time_.assign(cells, infinite);
  origin_.assign(cells, 0);
}

void LightingMap::mark_explosive(const std::vector<Shape>& shapes) {
  work_counts().undivided_points += static_cast<long long>(explosive_.size());
  for (std::size_t cell = 0; cell < explosive_.size(); ++cell) {
    const Vector x = centre_of(index_of(cell));
    const auto in = [&](const Shape& shape) {
      return holds(shape, x, static_cast<int>(dimension_));
    };
    explosive_[cell] = std::any_of(shapes.begin(), shapes.end(), in) ? 1 : 0;
  }
}

std::size_t LightingMap::flat(const Index& at) const {
  return (static_cast<std::size_t>(at[2]) * static_cast<std::size_t>(count_[1]) +
          static_cast<std::size_t>(at[1])) *
             static_cast<std::size_t>(count_[0]) +
         static_cast<std::size_t>(at[0]);
}

LightingMap::Index LightingMap::index_of(std::size_t cell) const {
  const auto x = static_cast<std::size_t>(count_[0]), y = static_cast<std::size_t>(count_[1]);
  return {
      static_cast<int>(cell % x), static_cast<int>(cell / x % y), static_cast<int>(cell / (x * y))};
}

LightingMap::Index LightingMap::cell_of(const Vector& x) const {
  Index at{};
  for (std::size_t d = 0; d < dimension_; ++d) {
    const double cell = std::floor((x[d] - grid_.lower[d]) / size_);
    at[d] = std::clamp(static_cast<int>(cell) - first_[d], 0, count_[d] - 1);
  }
  return at;
}

Vector LightingMap::centre_of(const Index& at) const {
  Vector x{};
  for (std::size_t d = 0; d < dimension_; ++d)
    x[d] = grid_.lower[d] + (first_[d] + at[d] + 0.5) * size_;
  return x;
}

bool LightingMap::has(const Index& at) const {
  for (std::size_t d = 0; d < dimension_; ++d)
    if (at[d] < 0 || at[d] >= count_[d]) return false;
  return explosive_[flat(at)] != 0;
}

/// All of the way is in cells of explosive, tried half a cell apart; its ends may lie on surfaces.
/// @pre both lie in the table, as all of an explosive does: no place on the way is left of its
/// first
///      cell, so that numbers of cells are cut off as they are rounded down
bool LightingMap::sees(const Vector& from, const Vector& x) const {
  const double cells = distance(from, x) / size_;
  std::array<double, 3> place{}, move{};
  for (std::size_t d = 0; d < dimension_; ++d) {
    move[d] = 0.5 * (x[d] - from[d]) / (size_ * cells);
    place[d] = (from[d] - grid_.lower[d]) / size_ - first_[d];
    if (!(place[d] >= 0.0 && place[d] < count_[d])) return false;
    place[d] += move[d];
  }
  const int tries = static_cast<int>(2.0 * cells - 1.0);
  const int row = count_[0], layer = count_[0] * count_[1];
  for (int i = 1; i < tries; ++i) {
    for (std::size_t d = 0; d < dimension_; ++d) place[d] += move[d];
    const int cell = static_cast<int>(place[0]) + row * static_cast<int>(place[1]) +
                     layer * static_cast<int>(place[2]);
    if (explosive_[static_cast<std::size_t>(cell)] == 0) return false;
  }
  return true;
}

/// Where the straight way of an origin to x starts, and when.
LightingMap::Start LightingMap::start_of(Origin origin, const Vector& x) const {
  if (origin >= 0) {
    const auto cell = static_cast<std::size_t>(origin);
    return {centre_of(index_of(cell)), time_[cell]};
  }
  const DetonatorSpec& detonator = detonation_.detonators[static_cast<std::size_t>(-1 - origin)];
  return {nearest_point(detonator, grid_.mode, x), detonator.time};
}

/// Straight from an origin, if that is earlier than a time known and the origin sees x.
/// @param[out] unseen  it would be earlier, but the origin does not see x
bool LightingMap::come_straight(Origin origin, const Vector& x, Arrival& arrival, bool& unseen)
    const {
  const Start start = start_of(origin, x);
  const double time = start.time + distance(start.x, x) / detonation_.speed;
  unseen = false;
  if (!(time < arrival.time)) return false;
  unseen = !sees(start.x, x);
  if (!unseen) arrival = {time, origin};
  return !unseen;
}

/// Straight from the cell's origin, or else from the cell, if that is earlier than a time known.
/// What comes from the cell is never before what comes from its origin.
bool LightingMap::come_through(std::size_t cell, const Vector& x, Arrival& arrival) const {
  bool unseen = false;
  if (come_straight(origin_[cell], x, arrival, unseen)) return true;
  if (!unseen) return false;
  const double way = distance(centre_of(index_of(cell)), x);
  const double time = time_[cell] + way / detonation_.speed;
  if (!(time < arrival.time)) return false;
  arrival = {time, static_cast<Origin>(cell)};
  return true;
}

/// The earliest cell that has not been passed on yet is right: no other can come before it.
void LightingMap::march() {
  using Next = std::pair<double, std::size_t>;
  std::priority_queue<Next, std::vector<Next>, std::greater<>> front;
  std::vector<unsigned char> known(time_.size(), 0);
  const auto put = [&](std::size_t cell, const Arrival& arrival) {
    time_[cell] = arrival.time;
    origin_[cell] = arrival.origin;
    front.emplace(arrival.time, cell);
  };
  // What a detonator sees within two cells of it.
  for (std::size_t cell = 0; cell < time_.size(); ++cell) {
    if (explosive_[cell] == 0) continue;
    const Vector x = centre_of(index_of(cell));
    for (std::size_t k = 0; k < detonation_.detonators.size(); ++k) {
      const Origin origin = -1 - static_cast<Origin>(k);
      Arrival arrival{time_[cell], origin};
      bool unseen = false;
      if (distance(start_of(origin, x).x, x) < 2.0 * size_ &&
          come_straight(origin, x, arrival, unseen))
        put(cell, arrival);
    }
  }
  while (!front.empty()) {
    const std::size_t cell = front.top().second;
    front.pop();
    if (known[cell] != 0) continue;
    known[cell] = 1;
    for_each_around(index_of(cell), dimension_, [&](const Index& next) {
      if (!has(next) || known[flat(next)] != 0) return;
      Arrival arrival{time_[flat(next)], origin_[flat(next)]};
      if (come_through(cell, centre_of(next), arrival)) put(flat(next), arrival);
    });
  }
}

bool LightingMap::reaches_all() const {
  std::size_t cells = 0;
  for (std::size_t cell = 0; cell < time_.size(); ++cell) {
    if (explosive_[cell] == 0) continue;
    if (time_[cell] == infinite) return false;
    ++cells;
  }
  return cells > 0;
}

/// The earliest arrival through the own cell or one around it.
double LightingMap::time_at(const Vector& x) const {
  Arrival first{infinite, 0};
  for_each_around(cell_of(x), dimension_, [&](const Index& at) {
    if (has(at) && time_[flat(at)] < infinite) come_through(flat(at), x, first);
  });
  return first.time;
}

}  // namespace barreno
