// SPDX-License-Identifier: BSD-3-Clause
#include "pore_flow/steady_flow.hpp"

#include "base/gather.hpp"
#include "base/numbers.hpp"
#include "deck/sections/pore_flow_section.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace barreno {
namespace {

enum Side { inward, outward, up, down };
constexpr std::array<Side, 4> sides{inward, outward, up, down};

/// What lies beyond a face of a cell.
struct Beyond {
  std::ptrdiff_t cell = -1;        ///< rock
  std::optional<double> pressure;  ///< of the hole or of the outside
};

class Rings {
public:
  explicit Rings(const RingCells& cells) : cells_(cells) {}

  bool is_rock(std::size_t c) const { return cells_.mobility[c] > 0.0 && cells_.hole[c] == 0; }

  Beyond beyond(std::size_t c, Side side) const {
    const std::size_t columns = cells_.columns(), i = c % columns, j = c / columns;
    if (side == inward) return i == 0 ? Beyond{} : neighbour(c - 1);
    if (side == outward) return i + 1 == columns ? edge(cells_.outside, j) : neighbour(c + 1);
    if (side == up) return j == 0 ? edge(cells_.above, i) : neighbour(c - columns);
    return j + 1 == cells_.rows() ? edge(cells_.below, i) : neighbour(c + columns);
  }

  /// G of a face [volume/(time stress)].
  double conductance(std::size_t c, Side side, const Beyond& beyond) const {
    const std::size_t i = c % cells_.columns(), j = c / cells_.columns();
    const double height = cells_.depths[j + 1] - cells_.depths[j];
    const double inner = cells_.radii[i], outer = cells_.radii[i + 1];
    const bool rock = beyond.cell >= 0;
    const auto n = static_cast<std::size_t>(rock ? beyond.cell : 0);
    double left = 0.0, area = 0.0;  // resistance over the area
    if (side == inward || side == outward) {
      const double face = side == inward ? inner : outer;
      left = std::abs(std::log(face / middle(i))) / cells_.mobility[c];
      if (rock)
        left += std::abs(std::log(middle(n % cells_.columns()) / face)) / cells_.mobility[n];
      area = 2.0 * pi * height;
    } else {
      left = 0.5 * height / cells_.mobility[c];
      const std::size_t row = n / cells_.columns();
      if (rock) left += 0.5 * (cells_.depths[row + 1] - cells_.depths[row]) / cells_.mobility[n];
      area = pi * (outer * outer - inner * inner);
    }
    return area / left;
  }

  /// Rock that is in touch with a pressure, by whatever way.
  std::vector<char> reached() const {
    std::vector<char> found(cells_.mobility.size(), 0);
    std::vector<std::size_t> next;
    for (std::size_t c = 0; c < found.size(); ++c) {
      if (!is_rock(c)) continue;
      for (const Side side : sides)
        if (found[c] == 0 && beyond(c, side).pressure) found[c] = 1, next.push_back(c);
    }
    while (!next.empty()) {
      const std::size_t c = next.back();
      next.pop_back();
      for (const Side side : sides) {
        const Beyond one = beyond(c, side);
        if (one.cell < 0 || found[static_cast<std::size_t>(one.cell)] != 0) continue;
        found[static_cast<std::size_t>(one.cell)] = 1;
        next.push_back(static_cast<std::size_t>(one.cell));
      }
    }
    return found;
  }

private:
  const RingCells& cells_;

  double middle(std::size_t i) const { return 0.5 * (cells_.radii[i] + cells_.radii[i + 1]); }
  Beyond neighbour(std::size_t n) const {
    if (cells_.hole[n] != 0) return {-1, cells_.hole_pressure};
    return {is_rock(n) ? static_cast<std::ptrdiff_t>(n) : -1, {}};
  }
  static Beyond edge(const std::vector<double>& pressures, std::size_t at) {
    if (pressures.empty()) return {};
    return {-1, pressures[at]};
  }
};

/// Rows of this rank, a part of all in their order.
LinearSystem system_of(
    const Rings& rings,
    const std::vector<std::size_t>& rock,
    const std::vector<long long>& id,
    const Comm& comm
) {
  const auto count = static_cast<long long>(rock.size()),
             ranks = static_cast<long long>(comm.getSize());
  const long long first = count * comm.getRank() / ranks,
                  past = count * (comm.getRank() + 1) / ranks;
  LinearSystem system;
  system.clear();
  for (long long row = first; row < past; ++row) {
    const std::size_t c = rock[static_cast<std::size_t>(row)];
    double diagonal = 0.0, right = 0.0;
    for (const Side side : sides) {
      const Beyond beyond = rings.beyond(c, side);
      if (beyond.cell < 0 && !beyond.pressure) continue;
      const double g = rings.conductance(c, side, beyond);
      diagonal += g;
      if (beyond.pressure)
        right += g * *beyond.pressure;
      else
        system.add(id[static_cast<std::size_t>(beyond.cell)], -g);
    }
    system.add(row, diagonal);
    system.end_row(row, right);
  }
  return system;
}

/// By MueLu, of few unknowns or where that fails by Gauss-Seidel: permeabilities may differ by many
/// orders.
SolveReport solve_rows(
    const LinearSystem& system,
    std::size_t unknowns,
    const Teuchos::RCP<const Comm>& comm,
    std::vector<double>& solution
) {
  constexpr double tolerance = 1e-13;  // of the residual: flows add up to its order
  Teuchos::ParameterList lists;
  lists.sublist("Belos").set("Convergence Tolerance", tolerance);
  lists.sublist("Belos").set("Maximum Iterations", 20000);
  if (unknowns >= fewest_cells_for_multigrid) {
    Teuchos::ParameterList grids = lists;
    grids.sublist("MueLu").set("verbosity", std::string("none"));
    SolveReport report = solve(system, false, *make_linear_solver(comm, grids), solution);
    if (report.converged) return report;
  }
  return solve(system, false, *make_linear_solver(comm, lists), solution);
}

/// Flows out of the rock, into the hole and to the outside, from the pressures.
void find_flows(const RingCells& cells, const Rings& rings, SteadyFlow& flow) {
  flow.into_hole.assign(cells.rows(), 0.0);
  for (std::size_t c = 0; c < flow.pressure.size(); ++c) {
    if (std::isnan(flow.pressure[c])) continue;
    const std::size_t i = c % cells.columns(), j = c / cells.columns();
    for (const Side side : sides) {
      const Beyond beyond = rings.beyond(c, side);
      if (!beyond.pressure) continue;
      const double out = rings.conductance(c, side, beyond) * (flow.pressure[c] - *beyond.pressure);
      if (side == outward && i + 1 == cells.columns())
        flow.from_outside -= out;
      else if (side == up && j == 0)
        flow.from_above -= out;
      else if (side == down && j + 1 == cells.rows())
        flow.from_below -= out;
      else
        flow.into_hole[j] += out;
    }
  }
}

bool ascends(const std::vector<double>& edges) {
  for (std::size_t k = 1; k < edges.size(); ++k)
    if (!(edges[k] > edges[k - 1])) return false;
  return edges.size() > 1;
}

bool all_finite(const std::vector<double>& values) {
  for (const double value : values)
    if (!std::isfinite(value)) return false;
  return true;
}

}  // namespace

std::string problem_of(const RingCells& cells) {
  if (!ascends(cells.radii) || !(cells.radii.front() >= 0.0))
    return "radii do not ascend from 0 or more";
  if (!ascends(cells.depths)) return "depths do not ascend";
  if (!all_finite(cells.radii) || !all_finite(cells.depths))
    return "an edge is not a finite number";
  const std::size_t count = cells.columns() * cells.rows();
  if (cells.mobility.size() != count || cells.hole.size() != count)
    return "mobility and hole do not have a value for every cell";
  for (const double mobility : cells.mobility)
    if (!(mobility >= 0.0) || !std::isfinite(mobility))
      return "a mobility is negative or not finite";
  if (!cells.outside.empty() && cells.outside.size() != cells.rows())
    return "outside does not have a pressure for every row";
  for (const auto* pressures : {&cells.above, &cells.below})
    if (!pressures->empty() && pressures->size() != cells.columns())
      return "above or below does not have a pressure for every column";
  if (!all_finite(cells.outside) || !all_finite(cells.above) || !all_finite(cells.below) ||
      !std::isfinite(cells.hole_pressure))
    return "a pressure is not a finite number";
  return {};
}

SteadyFlow solve_steady_flow(
    const RingCells& cells, const Teuchos::RCP<const Teuchos::Comm<int>>& comm
) {
  const Rings rings(cells);
  const std::vector<char> reached = rings.reached();
  std::vector<std::size_t> rock;
  std::vector<long long> id(reached.size(), -1);
  for (std::size_t c = 0; c < reached.size(); ++c) {
    if (reached[c] == 0) continue;
    id[c] = static_cast<long long>(rock.size());
    rock.push_back(c);
  }
  SteadyFlow flow;
  flow.pressure.assign(reached.size(), std::numeric_limits<double>::quiet_NaN());
  flow.into_hole.assign(cells.rows(), 0.0);
  flow.report.converged = true;
  if (rock.empty()) return flow;
  std::vector<double> own;
  flow.report = solve_rows(system_of(rings, rock, id, *comm), rock.size(), comm, own);
  const std::vector<double> all = gather_to_root(*comm, own);
  for (std::size_t k = 0; k < all.size(); ++k) flow.pressure[rock[k]] = all[k];
  if (is_root(*comm)) find_flows(cells, rings, flow);
  return flow;
}

}  // namespace barreno
