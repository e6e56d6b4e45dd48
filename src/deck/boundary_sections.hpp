// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <barreno/input/schema.hpp>
#include <string>

namespace barreno {

/// What decks call the faces of a box, in the order of Face.
extern const std::array<std::string, 6> face_names;

/// The lists of a deck that say what acts on the surfaces of bodies and on the faces of the grid.
input::Section conditions_section();
input::Section loads_section();
input::Section confinement_section();
input::Section contact_section();

}  // namespace barreno
