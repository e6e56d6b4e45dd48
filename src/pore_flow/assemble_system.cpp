// SPDX-License-Identifier: BSD-3-Clause
#include "pore_flow/assemble_system.hpp"

#include "base/region.hpp"

namespace barreno {
namespace {

double pressure_of(const PoreNetwork& network, std::size_t i, bool changed) {
  return network.cells.cells[i].pressure + (changed ? network.change[i] : 0.0);
}

/// One row; a cell without rock keeps its pressure of nothing.
void add_row(double dt, std::size_t i, PoreNetwork& network) {
  const PoreCells& cells = network.cells;
  LinearSystem& system = network.system;
  if (!(cells.cells[i].storage > 0.0)) {
    // The graph of a row with rock: rock may come into a cell of the same list.
    for (const int next : cells.next[i])
      if (next >= 0) system.add(cells.ids[static_cast<std::size_t>(next)], 0.0);
    system.add(cells.ids[i], 1.0);
    system.end_row(cells.ids[i], 0.0);
    return;
  }
  double diagonal = cells.emptied[i] ? 0.0 : cells.cells[i].storage / dt, inflow = 0.0;
  // What empties gives all that it holds, whether or not the round before filled its gap.
  if (cells.emptied[i])
    inflow += cells.cells[i].content / dt;
  else if (cells.filled[i])
    inflow -= cells.cells[i].gap / dt;
  for (std::size_t face = 0; face < network.links[i].size(); ++face) {
    const PoreLink& link = network.links[i][face];
    diagonal += link.conductance;
    inflow += flow_through(network, i, face, false);
    // Neighbours stay in the graph when nothing flows: it must not change with permeability.
    if (cells.next[i][face] >= 0)
      system.add(cells.ids[static_cast<std::size_t>(cells.next[i][face])], -link.conductance);
  }
  system.add(cells.ids[i], diagonal);
  system.end_row(cells.ids[i], inflow);
}

}  // namespace

void link_pore_cells(const PorousMedium& medium, PoreNetwork& network) {
  const Region region("link_pore_cells");
  const PoreCells& cells = network.cells;
  network.links.assign(static_cast<std::size_t>(cells.own), {});
  const std::size_t faces = 2 * static_cast<std::size_t>(medium.grid.patch.dimensions);
  for (std::size_t i = 0; i < network.links.size(); ++i)
    if (cells.cells[i].storage > 0.0)
      for (std::size_t face = 0; face < faces; ++face)
        network.links[i][face] = pore_link(medium, cells, i, face);
}

void assemble_system(double dt, PoreNetwork& network) {
  const Region region("assemble_system");
  network.system.clear();
  for (std::size_t i = 0; i < network.links.size(); ++i) add_row(dt, i, network);
}

double flow_through(const PoreNetwork& network, std::size_t i, std::size_t face, bool changed) {
  const PoreLink& link = network.links[i][face];
  if (!(link.conductance > 0.0)) return link.prescribed_flow;
  double outside = link.outside;
  if (link.cell >= 0) outside += pressure_of(network, static_cast<std::size_t>(link.cell), changed);
  return link.conductance * (outside - pressure_of(network, i, changed)) + link.prescribed_flow;
}

}  // namespace barreno
