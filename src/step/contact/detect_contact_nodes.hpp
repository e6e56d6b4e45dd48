// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state/state.hpp"

namespace barreno {

/// Find the nodes at which two or more velocity fields have mass, and make room for what contact
/// needs there. Nothing to do with one field.
///
/// @pre  the sums of all fields hold each tile's own part, ghosts included (exchange_halo)
/// @post contact.fields and contact.shared_tile are those of the own tiles
void detect_contact_nodes(
    const Grid& grid,
    const VelocityFields& fields,
    const std::vector<Particles>& sets,
    std::vector<Nodes>& nodes,
    ContactNodes& contact
);

}  // namespace barreno
