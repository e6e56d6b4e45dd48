// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <barreno/input/schema.hpp>

namespace barreno {

/// The lists of a deck that say what acts on the surfaces of bodies and on the faces of the grid.
input::Section conditions_section();
input::Section loads_section();
input::Section confinement_section();
input::Section contact_section();

}  // namespace barreno
