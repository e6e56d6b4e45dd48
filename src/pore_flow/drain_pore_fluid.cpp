// SPDX-License-Identifier: BSD-3-Clause
#include "pore_flow/drain_pore_fluid.hpp"

#include "base/gather.hpp"
#include "base/region.hpp"
#include "pore_flow/assemble_system.hpp"
#include "pore_flow/drain_particles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace barreno {
namespace {

/// Cells, neighbours and links of now.
/// @return whether the graph is that of the last solve on every rank
bool build_network(const PorousMedium& medium, PoreNetwork& network) {
  const bool kept = fill_pore_cells(medium, network.cells) && network.halo;
  std::array<double, 1> changed{kept ? 0.0 : 1.0};
  max_over_ranks(*medium.grid.comm, changed);
  if (changed[0] > 0.0) network.halo = build_pore_halo(medium.grid, network.cells);
  exchange_pore_cells(*network.halo, network.cells);
  link_pore_cells(medium, network);
  return changed[0] == 0.0;
}

std::string not_converged(double time, const SolveReport& report) {
  std::ostringstream text;
  text
      << "The pore pressure at t = " << time << " s was not found: " << report.method
      << " left a residual of " << report.residual << " after " << report.iterations
      << " iterations. Raise Belos/Maximum Iterations, choose another preconditioner in Pore Flow, "
         "or solve more often with a smaller Diffusion Number.";
  return text.str();
}

std::string not_drained(double time, double failures) {
  std::ostringstream text;
  text << "At t = " << time << " s " << failures
       << " particles could not accept the change in their pore pressure (more fluid would leave "
          "than they hold, or their stress update failed), and their policy is to stop. Set \"Bad "
          "Particles\" to remove or hold, or solve more often with a smaller Diffusion Number.";
  return text.str();
}

/// Darcy velocity in the middle of a cell: the mean of those in its faces, sealed ones with none.
Vector cell_flux(const PoreNetwork& network, std::size_t i) {
  Vector flux{};
  for (std::size_t face = 0; face < network.links[i].size(); ++face) {
    const PoreLink& link = network.links[i][face];
    if (!(link.area > 0.0)) continue;
    const double into = flow_through(network, i, face, true) / link.area;
    flux[face / 2] += 0.5 * (face % 2 == 0 ? into : -into);
  }
  return flux;
}

/// So much of its slope that the line through a cell stays between the pressures around it, those
/// of open faces included: particles take no pressure that is not there. Weight is left aside.
double cell_steepness(const PoreNetwork& network, std::size_t i) {
  const PoreCell& cell = network.cells.cells[i];
  double up = 0.0, down = 0.0, rise = 0.0;
  for (std::size_t face = 0; face < network.links[i].size(); ++face) {
    const PoreLink& link = network.links[i][face];
    if (!(link.conductance > 0.0)) continue;
    const double difference = flow_through(network, i, face, true) / link.conductance;
    up = std::max(up, difference);
    down = std::max(down, -difference);
  }
  for (std::size_t d = 0; d < 3; ++d)
    if (cell.mobility[d] > 0.0)
      rise += std::abs(network.flux[i][d]) / cell.mobility[d] *
              std::max(cell.upper[d] - cell.centroid[d], cell.centroid[d] - cell.lower[d]);
  const double room = std::min(up, down);
  return rise > room ? room / rise : 1.0;
}

/// What the solve has moved on this rank.
struct FlowTally {
  double inflow = 0.0;  ///< from outside [volume]
  double work = 0.0;    ///< that the fluid brings into the rock where it comes in, p dv [energy]
};

/// Fluid that comes into an own cell, at its initial density [volume].
double fluid_taken(const PoreNetwork& network, std::size_t i) {
  const PoreCell& cell = network.cells.cells[i];
  if (network.cells.emptied[i]) return -cell.content;
  return cell.storage * network.change[i] + (network.cells.filled[i] ? cell.gap : 0.0);
}

/// Fluxes of the cells, and the sums over them.
FlowTally tally_flow(double dt, PoreNetwork& network) {
  FlowTally tally;
  network.flux.resize(network.links.size());
  network.steepness.resize(network.links.size());
  for (std::size_t i = 0; i < network.links.size(); ++i) {
    const PoreCell& cell = network.cells.cells[i];
    network.flux[i] = cell_flux(network, i);
    network.steepness[i] = cell_steepness(network, i);
    for (std::size_t face = 0; face < network.links[i].size(); ++face)
      if (network.links[i][face].cell < 0)
        tally.inflow += dt * flow_through(network, i, face, true);
    const double change = std::max(network.change[i], -cell.pressure);
    tally.work += (cell.pressure + 0.5 * change) * fluid_taken(network, i);
  }
  return tally;
}

/// Time in which the fastest cell evens out over Diffusion Number cells; that of the run where
/// nothing flows.
double drain_interval(const PorousMedium& medium, const PoreNetwork& network) {
  std::array<double, 1> fastest{0.0};
  for (int i = 0; i < network.cells.own; ++i) {
    const PoreCell& cell = network.cells.cells[static_cast<std::size_t>(i)];
    if (!(cell.storage > 0.0)) continue;
    const double mobility = std::max({cell.mobility[0], cell.mobility[1], cell.mobility[2]});
    fastest[0] = std::max(fastest[0], mobility * cell.volume / cell.storage);
  }
  max_over_ranks(*medium.grid.comm, fastest);
  const double h = medium.grid.cell_size;
  if (!(fastest[0] > 0.0)) return medium.end_time;
  return medium.flow.diffusion_number * h * h / fastest[0];
}

bool leaks(const PoreNetwork& network, std::size_t i) {
  const auto& links = network.links[i];
  return std::any_of(links.begin(), links.end(), [](const PoreLink& link) {
    return link.conductance > 0.0;
  });
}

/// Whether the rise of pressure fills the gap of a cell.
bool fills(const PoreNetwork& network, std::size_t i) {
  const PoreCell& cell = network.cells.cells[i];
  if (!(cell.gap > 0.0)) return false;
  // Full pores have another mean pressure than those with gas.
  const double rise = network.change[i] + (network.cells.filled[i] ? cell.pressure : 0.0);
  return rise > cell.gap_pressure;
}

/// Whether the fall of pressure takes all that a cell holds.
bool empties(const PoreNetwork& network, std::size_t i) {
  const PoreCell& cell = network.cells.cells[i];
  const double gap = network.cells.filled[i] ? cell.gap : 0.0;
  return -(cell.storage * network.change[i] + gap) > cell.content && leaks(network, i);
}

/// Finds the cells whose gap is filled, and those that are emptied. Pressures rise and fall steeply
/// beyond: without this the first would take what the gas alone could, many times the gap, and the
/// others lose more than they hold (pores of crushed rock close before their pressure is gone).
/// @return whether they are others than before
bool fill_or_empty(const PorousMedium& medium, PoreNetwork& network) {
  PoreCells& cells = network.cells;
  std::array<double, 2> others{0.0, 0.0};
  for (std::size_t i = 0; i < cells.filled.size(); ++i) {
    const char filled = fills(network, i) ? 1 : 0, emptied = empties(network, i) ? 1 : 0;
    if (filled != cells.filled[i]) others[0] = 1.0;
    if (filled != cells.filled[i] || emptied != cells.emptied[i]) others[1] = 1.0;
    cells.filled[i] = filled;
    cells.emptied[i] = emptied;
  }
  max_over_ranks(*medium.grid.comm, others);
  if (others[0] > 0.0) {
    sum_pore_cells(medium, cells);
    exchange_pore_cells(*network.halo, cells);
    link_pore_cells(medium, network);
  }
  return others[1] > 0.0;
}

/// The change of pressure in all cells, by Newton's method: the fluid that a cell takes is linear
/// in the pressure but for where a gap is full and where nothing is left. A cell on the edge of its
/// gap may go to and fro: the last round keeps the mass as well.
SolveReport find_change(const PorousMedium& medium, double dt, PoreNetwork& network) {
  constexpr int max_rounds = 20;
  bool same_graph = build_network(medium, network);
  int iterations = 0;
  for (int round = 1;; ++round) {
    assemble_system(dt, network);
    SolveReport report = solve(network.system, same_graph, *network.solver, network.change);
    report.iterations = iterations += report.iterations;
    if (!report.converged || round == max_rounds || !fill_or_empty(medium, network)) return report;
    same_graph = true;
  }
}

}  // namespace

std::string drain_pore_fluid(
    const PorousMedium& medium, double dt, PoreFlowState& flow, OwnLedger& ledger
) {
  if (!medium.flow.on()) return {};
  const Region region("drain_pore_fluid");
  flow.waiting += dt;
  if (flow.waiting < flow.interval) return {};
  if (!flow.network) {
    flow.network = std::make_shared<PoreNetwork>();
    flow.network->solver = make_linear_solver(
        medium.grid.comm, medium.flow.solver ? *medium.flow.solver : Teuchos::ParameterList()
    );
  }
  PoreNetwork& network = *flow.network;

  const SolveReport report = find_change(medium, flow.waiting, network);
  if (!report.converged) return not_converged(medium.time, report);
  exchange_pore_values(*network.halo, network.change);
  const FlowTally moved = tally_flow(flow.waiting, network);
  const DrainTally drained = drain_particles(medium, flow.waiting, network);

  std::array<double, 4> sums{moved.inflow, drained.fluid, drained.stops, drained.fluid_before};
  sum_over_ranks(*medium.grid.comm, sums);
  ledger.fluid_work += moved.work;
  for (std::size_t m = 0; m < drained.materials.size(); ++m) {
    const auto [elastic, plastic] = drained.materials[m];
    ledger.elastic += elastic;
    ledger.plastic += plastic;
    ledger.materials[m].elastic += elastic;
    ledger.materials[m].plastic += plastic;
  }
  ledger.held += drained.held;
  flow.inflow += sums[0];
  // Only the flow changes the fluid of a particle.
  if (flow.solves == 0)
    flow.initial_fluid = sums[3];
  else
    flow.removed += flow.fluid - sums[3];
  flow.fluid = sums[1];
  flow.iterations += report.iterations;
  ++flow.solves;
  flow.interval = drain_interval(medium, network);
  flow.waiting = 0.0;
  return sums[2] > 0.0 ? not_drained(medium.time, sums[2]) : std::string();
}

}  // namespace barreno
