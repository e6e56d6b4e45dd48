// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <barreno/input/schema.hpp>

namespace barreno {

/// The list of a deck that says how a step is taken.
input::Section step_section();
input::Section quasi_static_section();

}  // namespace barreno
