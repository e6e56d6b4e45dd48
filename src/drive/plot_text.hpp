// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drive/driven_state.hpp"

#include <barreno/models.hpp>
#include <string>
#include <vector>

namespace barreno {

/// What src/python/barreno/materials/plot_drive.py reads: lines "# word: value", a CSV table with a
/// row for each state (time; strain, stress and bounded stress, see yield_view.hpp, each xx yy zz
/// xy yz zx; pore_pressure where the model has one), a line "# yield surface" and the table of
/// yield_table.hpp, which may be empty.
/// @param path  name of the path, for the picture's title
std::string plot_text(
    const Material& material,
    const std::vector<DrivenState>& states,
    const std::string& yield_table,
    const std::string& path
);

}  // namespace barreno
