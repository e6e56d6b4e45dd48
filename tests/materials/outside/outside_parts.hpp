// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What BARRENO_OUTSIDE_PARTS names in the tests of parts from outside of the library: a header for
// each part, and one line for each.
#include "compaction_curve.hpp"
#include "fading_dilatancy.hpp"
#include "lundborg_limit.hpp"

namespace barreno::arenisca::outside {

using ShearLimits = PartList<LundborgLimit>;
using CrushCurves = PartList<CompactionCurve>;
using FlowRules = PartList<FadingDilatancy>;

}  // namespace barreno::arenisca::outside
