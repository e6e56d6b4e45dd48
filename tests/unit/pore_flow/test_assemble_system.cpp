// SPDX-License-Identifier: BSD-3-Clause
#include "pore_flow/assemble_system.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

/// Two cells, the first of which the round before has filled and emptied.
PoreNetwork two_cells(bool filled, bool emptied) {
  PoreNetwork network;
  PoreCells& cells = network.cells;
  cells.own = 2;
  cells.ids = {0, 1};
  cells.cells.resize(2);
  for (PoreCell& cell : cells.cells) {
    cell.storage = 2.0;
    cell.content = 5.0;
    cell.gap = 0.25;
  }
  cells.filled = {static_cast<char>(filled), 0};
  cells.emptied = {static_cast<char>(emptied), 0};
  cells.next = {{-1, 1, -1, -1, -1, -1}, {0, -1, -1, -1, -1, -1}};
  network.links.resize(2);
  network.links[0][1] = {3.0, 1, 0.0, 0.0, 1.0};
  network.links[1][0] = {3.0, 0, 0.0, 0.0, 1.0};
  network.change.assign(2, 0.0);
  return network;
}

constexpr double dt = 0.5;

double first_right_side(bool filled, bool emptied) {
  PoreNetwork network = two_cells(filled, emptied);
  assemble_system(dt, network);
  return network.system.right_side[0];
}

TEST(AssembleSystem, AFilledCellTakesItsGapBesideWhatItStores) {
  EXPECT_EQ(first_right_side(true, false), -0.25 / dt);
}

TEST(AssembleSystem, AnEmptiedCellGivesWhatItHoldsWhetherOrNotItsGapWasFilled) {
  EXPECT_EQ(first_right_side(false, true), 5.0 / dt);
  EXPECT_EQ(first_right_side(true, true), 5.0 / dt);
}

}  // namespace
}  // namespace barreno
