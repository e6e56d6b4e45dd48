// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <barreno/input/schema.hpp>

namespace barreno {

/// The list of a deck that says how pore fluid drains.
input::Section pore_flow_section();

}  // namespace barreno
