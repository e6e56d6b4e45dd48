// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pore_flow/pore_cells.hpp"

#include <memory>

namespace barreno {

/// The plan by which ranks tell each other of the cells along their borders (Tpetra); hidden to
/// keep compile times low.
struct PoreHalo;

/// Find the cells of other ranks next to own ones, append them, and find who is next to whom.
/// Collective.
std::shared_ptr<PoreHalo> build_pore_halo(const Grid& grid, PoreCells& cells);

/// The owners' cells into the rows behind the own ones, which are added where they are not there.
/// Collective.
void exchange_pore_cells(const PoreHalo& halo, PoreCells& cells);

/// The same for one value per cell: `values` has the own ones and gets the others'. Collective.
void exchange_pore_values(const PoreHalo& halo, std::vector<double>& values);

}  // namespace barreno
