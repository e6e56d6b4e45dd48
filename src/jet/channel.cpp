// SPDX-License-Identifier: BSD-3-Clause
#include "jet/channel.hpp"

#include "base/gather.hpp"
#include "base/numbers.hpp"
#include "jet/drawn_shape.hpp"
#include "scene/materials/liquids.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

/// Whole numbers add up the same in every order: parts of a cell that are filled.
constexpr double fill_quantum = 1.0 / 1099511627776.0;

/// Cells across the path are divided, so that a wall is found between their faces.
constexpr int parts_across = 4;
/// Half of a window one cell wide, in these parts.
constexpr int half_window = parts_across / 2;

/// Bins along the path (rows, a cell high) and away from the axis (columns, a part of a cell wide).
struct PathBins {
  double height = 0.0, width = 0.0;  ///< [length]
  int rows = 0, columns = 0;
  bool ring = false;
  double part = 1.0;  ///< of a ring, or of the two sides of a plane, that the grid holds

  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  /// Area in the plane through the axis of what has this measure in the grid's dimensions.
  double section(double measure, double radius) const {
    return measure / (part * (ring ? two_pi * radius : 1.0));
  }
};

PathBins path_bins(const GridSpec& grid, const JetPath& path) {
  PathBins bins;
  bins.height = path.bin;
  bins.width = path.bin / parts_across;
  bins.rows = path.bins;
  const double across = std::max(std::abs(grid.lower[0]), std::abs(grid.upper[0]));
  bins.columns = parts_across * static_cast<int>(std::ceil(across / path.bin));
  bins.ring = grid.mode == Mode::three_dimensional;
  if (grid.mode == Mode::plane_strain && grid.lower[0] < 0.0) bins.part = 2.0;
  if (grid.mode == Mode::three_dimensional)
    for (const std::size_t axis : {0U, 2U}) bins.part *= grid.lower[axis] < 0.0 ? 1.0 : 0.5;
  return bins;
}

/// Adds the section that a particle fills to the bins that its box covers,
/// each by its share of the box: particles may be wider than a bin.
void fill_around(
    const PathBins& bins,
    double depth,
    double radius,
    const double (&half)[2],
    double filled,
    std::vector<long long>& fill
) {
  const double inner = std::max(0.0, radius - half[0]), outer = radius + half[0];
  const double near = depth - half[1], far = depth + half[1];
  const auto bin_of = [](double at, double width, int count) {
    return static_cast<int>(std::clamp(std::floor(at / width), 0.0, count - 1.0));
  };
  const double area = (outer - inner) * (far - near);
  if (!(area > 0.0)) return;  // squashed flat
  const double dense = bins.section(filled, 0.5 * (inner + outer)) / area;
  const int first = bin_of(inner, bins.width, bins.columns),
            last = bin_of(outer, bins.width, bins.columns);
  for (int row = bin_of(near, bins.height, bins.rows); row <= bin_of(far, bins.height, bins.rows);
       ++row)
    for (int column = first; column <= last; ++column) {
      const double along = overlap(near, far, row * bins.height, (row + 1) * bins.height);
      const double across = overlap(inner, outer, column * bins.width, (column + 1) * bins.width);
      const double share = dense * along * across / (bins.height * bins.width);
      fill[bins.index(row, column)] += std::llround(share / fill_quantum);
    }
}

/// Filled part of the bins, of this rank.
std::vector<long long> fill_bins(
    const std::vector<HostParticles>& sets,
    const Scene& scene,
    const JetPath& path,
    const PathBins& bins
) {
  std::vector<long long> fill(bins.index(bins.rows, 0));
  std::vector<double> corners;
  for (std::size_t set = 0; set < sets.size() && bins.rows > 0; ++set) {
    const HostParticles& particles = sets[set];
    const double density = scene.materials[set].density();
    // A liquid that flows into the hole does not fill it.
    if (is_liquid(scene.materials[set])) continue;
    // Gas that has formed the jet follows it into the channel, and does not fill it.
    if (path.origin.formed && scene.materials[set].detonation_speed()) continue;
    for (int p = 0; p < particles.count; ++p) {
      if (is_jet_body(path.origin, particles.body(p) & ~debris_bit)) continue;  // the jet itself
      // Expanded debris fills no more than it did as rock.
      const double ratio = std::min(1.0, particles.mass(p, 0) / (density * particles.volume(p, 0)));
      corners.clear();
      particles.append_corners(p, corners);
      const DrawnShape shape(corners, std::pow(ratio, 1.0 / particles.dimensions()));
      const auto [across, radius] = away_from_axis(particles, p);
      const double half[2] = {shape.half_extent(across), shape.half_extent({0.0, 1.0, 0.0})};
      const double depth = path.depth(particles.position(p, 1));
      fill_around(bins, depth, radius, half, shape.measure(), fill);
    }
  }
  return fill;
}

/// Filled part of a window one cell wide around the inner face of a column. The other side of the
/// axis looks the same. What is covered twice counts once.
double window_fill(const long long* row, int column) {
  constexpr auto full = static_cast<long long>(1.0 / fill_quantum);
  long long sum = 0;
  for (int c = column - half_window; c < column + half_window; ++c)
    sum += std::min(full, row[c < 0 ? -1 - c : c]);
  return static_cast<double>(sum) * fill_quantum / parts_across;
}

/// Distance from the axis to where target fills half of such a window, linear in between; the width
/// of the bins where it does so nowhere.
double wall_radius(const PathBins& bins, const long long* row) {
  double before = 0.0;
  for (int c = 0; c + half_window <= bins.columns; ++c) {
    const double fill = window_fill(row, c);
    if (fill >= 0.5) return c == 0 ? 0.0 : (c - 1 + (0.5 - before) / (fill - before)) * bins.width;
    before = fill;
  }
  return bins.columns * bins.width;
}

}  // namespace

std::vector<double> wall_radii(
    const std::vector<HostParticles>& sets,
    const Scene& scene,
    const JetPath& path,
    const Comm& comm
) {
  const PathBins bins = path_bins(scene.grid, path);
  std::vector<long long> fill = fill_bins(sets, scene, path, bins);
  sum_over_ranks(comm, fill);
  std::vector<double> radii;
  radii.reserve(static_cast<std::size_t>(bins.rows));
  for (int row = 0; row < bins.rows; ++row)
    radii.push_back(wall_radius(bins, fill.data() + bins.index(row, 0)));
  return radii;
}

namespace {

/// Below this radius a hole is closed, as in the report [cells].
constexpr double closed_radius = 0.25;

/// Radius at a depth in rows, linear between the middles of open rows: crumbs fill the others.
double radius_at(const std::vector<double>& radii, std::size_t open, double depth, double closed) {
  double before = -1.0, radius = 0.0;
  for (std::size_t row = 0; row < open; ++row) {
    if (radii[row] < closed) continue;
    const double middle = static_cast<double>(row) + 0.5;
    if (middle >= depth)
      return before < 0.0 ? radii[row]
                          : radius + (radii[row] - radius) * (depth - before) / (middle - before);
    before = middle;
    radius = radii[row];
  }
  return radius;
}

}  // namespace

namespace {

/// Rows from the face to the last whose wall is at least this far away, before a narrower stretch
/// of more than so many rows.
std::size_t rows_as_wide(const std::vector<double>& radii, double least, std::size_t neck) {
  std::size_t wide = 0;
  for (std::size_t row = 0; row < radii.size() && row - wide <= neck; ++row)
    if (radii[row] >= least) wide = row + 1;
  return wide;
}

/// In how many of its own diameters on either side a probe looks for rows as wide as it.
constexpr double diameters_around = 5.0;

/// Rows from the face to where no more than half of the rows on either side are as wide as a probe.
/// Fewer are looked at near the ends, as many on one side as on the other.
std::size_t rows_mostly_as_wide(const std::vector<double>& radii, double probe, double bin) {
  const auto reach = static_cast<std::size_t>(std::lround(2.0 * diameters_around * probe / bin));
  std::vector<std::size_t> wide_before(radii.size() + 1, 0);
  for (std::size_t row = 0; row < radii.size(); ++row)
    wide_before[row + 1] = wide_before[row] + (radii[row] >= probe ? 1 : 0);
  std::vector<double> mostly(radii.size());
  for (std::size_t row = 0; row < radii.size(); ++row) {
    const std::size_t side = std::min({reach, row, radii.size() - 1 - row});
    const std::size_t wide = wide_before[row + side + 1] - wide_before[row - side];
    mostly[row] = 2 * wide > 2 * side + 1 ? probe : 0.0;
  }
  const auto crumbs = static_cast<std::size_t>(2.0 * probe / bin);
  return rows_as_wide(mostly, probe, std::max<std::size_t>(1, crumbs));
}

}  // namespace

void measure_channel(const std::vector<double>& radii, const JetPath& path, Penetration& result) {
  const double closed = closed_radius * path.bin;
  const double length = path.direction * (path.end - path.face);
  const auto length_of = [&](std::size_t rows) {
    return std::min(static_cast<double>(rows) * path.bin, length);
  };
  const std::size_t open = rows_as_wide(radii, closed, 1);
  result.channel_depth = length_of(open);
  const double probe = std::max(closed, path.origin.radius);
  result.probed_depth = length_of(rows_mostly_as_wide(radii, probe, path.bin));
  result.channel_radius_mid = radius_at(radii, open, 0.5 * static_cast<double>(open), closed);
}

double wall_at(const JetPath& path, const Penetration& found, double depth) {
  const auto open = static_cast<std::size_t>(std::lround(found.channel_depth / path.bin));
  return radius_at(
      found.walls, std::min(open, found.walls.size()), depth / path.bin, closed_radius * path.bin
  );
}

double entrance_diameter(const PathLayer& layer, const JetPath& path, const Penetration& found) {
  constexpr double round_off = 1e-9;
  const double rows = (layer.near - path.direction * path.face) / path.bin;
  const auto row = static_cast<std::size_t>(std::max(0.0, std::ceil(rows - round_off)));
  if (row >= found.walls.size() || found.walls[row] < closed_radius * path.bin) return 0.0;
  return 2.0 * found.walls[row];
}

namespace {

/// Of the rows from the face to a depth.
double volume_to(
    const GridSpec& grid, const JetPath& path, const std::vector<double>& walls, double depth
) {
  const PathBins bins = path_bins(grid, path);
  const double no_wall = bins.columns * bins.width;
  double volume = 0.0;
  for (std::size_t row = 0; row < walls.size(); ++row) {
    const double height = std::min(bins.height, depth - static_cast<double>(row) * bins.height);
    if (!(height > 0.0)) break;
    const double radius = walls[row];
    if (radius >= no_wall) continue;
    volume += height * (grid.mode == Mode::plane_strain ? 2.0 * radius : pi * radius * radius);
  }
  return volume;
}

}  // namespace

double channel_volume(const GridSpec& grid, const JetPath& path, const Penetration& found) {
  return volume_to(grid, path, found.walls, found.channel_depth);
}

double probed_volume(const GridSpec& grid, const JetPath& path, const Penetration& found) {
  return volume_to(grid, path, found.walls, found.probed_depth);
}

}  // namespace barreno
