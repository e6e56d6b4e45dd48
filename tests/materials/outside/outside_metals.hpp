// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What BARRENO_OUTSIDE_METALS names in the tests of parts from outside of the library: a header for
// each part, and one line for each.
#include "tillotson.hpp"
#include "zerilli_armstrong.hpp"

namespace barreno::metal::outside {

using Strengths = PartList<ZerilliArmstrong>;
using EquationsOfState = PartList<Tillotson>;
using Failures = PartList<>;

}  // namespace barreno::metal::outside
