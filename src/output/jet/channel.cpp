// SPDX-License-Identifier: BSD-3-Clause
#include "output/jet/channel.hpp"

#include "base/gather.hpp"
#include "base/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

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
  /// Area that a volume around a radius has in the plane through the axis.
  double section(double volume, double radius) const {
    return volume / (part * (ring ? two_pi * radius : 1.0));
  }
};

PathBins path_bins(const GridSpec& grid, const JetPath& path) {
  PathBins bins;
  bins.height = path.bin;
  bins.width = path.bin / parts_across;
  bins.rows = path.bins;
  const double across = std::max(std::abs(grid.lower[0]), std::abs(grid.upper[0]));
  bins.columns = parts_across * static_cast<int>(std::ceil(across / path.bin));
  bins.ring = grid.mode != Mode::plane_strain;
  if (grid.mode == Mode::plane_strain && grid.lower[0] < 0.0) bins.part = 2.0;
  if (grid.mode == Mode::three_dimensional)
    for (const std::size_t axis : {0U, 2U}) bins.part *= grid.lower[axis] < 0.0 ? 1.0 : 0.5;
  return bins;
}

/// Length that two intervals share.
double overlap(double from, double to, double lower, double upper) {
  return std::max(0.0, std::min(to, upper) - std::max(from, lower));
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

/// Half the extent along an axis of the box whose moments are those of the deformed particle
/// [length]: h_i^2 = sum_j (F_ij h_j)^2.
double half_extent(const HostParticles& particles, int p, int axis) {
  const int dimension = static_cast<int>(particles.half_size.extent(1));
  double square = 0.0;
  for (int j = 0; j < dimension; ++j) {
    const double edge =
        particles.deformation_gradient(p, axis * dimension + j) * particles.half_size(p, j);
    square += edge * edge;
  }
  return std::sqrt(square);
}

/// Filled part of the bins, of this rank.
std::vector<long long> fill_bins(
    const std::vector<HostParticles>& sets,
    const Scene& scene,
    const JetPath& path,
    const PathBins& bins
) {
  std::vector<long long> fill(bins.index(bins.rows, 0));
  for (std::size_t set = 0; set < sets.size() && bins.rows > 0; ++set) {
    const HostParticles& particles = sets[set];
    const double density = scene.materials[set].density();
    // Gas that has formed the jet follows it into the channel, and does not fill it.
    if (path.origin.formed && scene.materials[set].detonation_speed()) continue;
    for (int p = 0; p < particles.count; ++p) {
      if (is_jet_body(path.origin, particles.body(p) & ~debris_bit)) continue;  // the jet itself
      const bool space = scene.grid.mode == Mode::three_dimensional;
      const double radius =
          std::hypot(particles.position(p, 0), space ? particles.position(p, 2) : 0.0);
      // Expanded debris fills no more than it did as rock.
      const double filled = std::min(particles.volume(p, 0), particles.mass(p, 0) / density);
      const double shrunk = std::sqrt(filled / particles.volume(p, 0));
      const double half[2] = {
          shrunk * half_extent(particles, p, 0), shrunk * half_extent(particles, p, 1)};
      fill_around(bins, path.depth(particles.position(p, 1)), radius, half, filled, fill);
    }
  }
  return fill;
}

/// Filled part of a window one cell wide around the inner face of a column. The other side of the
/// axis looks the same.
double window_fill(const long long* row, int column) {
  long long sum = 0;
  for (int c = column - half_window; c < column + half_window; ++c) sum += row[c < 0 ? -1 - c : c];
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

void measure_channel(const std::vector<double>& radii, const JetPath& path, Penetration& result) {
  const double closed = closed_radius * path.bin;
  const std::size_t last = radii.size() - 1;
  std::size_t open = 0;
  while (open < radii.size() && (radii[open] >= closed || radii[std::min(open + 1, last)] >= closed)
  )
    ++open;
  result.channel_depth =
      std::min(static_cast<double>(open) * path.bin, path.direction * (path.end - path.face));
  result.channel_radius_mid = radius_at(radii, open, 0.5 * static_cast<double>(open), closed);
}

double entrance_diameter(const PathLayer& layer, const JetPath& path, const Penetration& found) {
  constexpr double round_off = 1e-9;
  const double rows = (layer.near - path.direction * path.face) / path.bin;
  const auto row = static_cast<std::size_t>(std::max(0.0, std::ceil(rows - round_off)));
  if (row >= found.walls.size() || found.walls[row] < closed_radius * path.bin) return 0.0;
  return 2.0 * found.walls[row];
}

}  // namespace barreno
