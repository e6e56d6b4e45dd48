// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/parts/accuracy.hpp"
#include "barreno/arenisca/parts/breakage.hpp"
#include "barreno/arenisca/parts/cap_shape.hpp"
#include "barreno/arenisca/parts/crush_curve.hpp"
#include "barreno/arenisca/parts/damage.hpp"
#include "barreno/arenisca/parts/elasticity.hpp"
#include "barreno/arenisca/parts/flow_rule.hpp"
#include "barreno/arenisca/parts/fluid.hpp"
#include "barreno/arenisca/parts/heat.hpp"
#include "barreno/arenisca/parts/lode.hpp"
#include "barreno/arenisca/parts/rate.hpp"
#include "barreno/arenisca/parts/scatter.hpp"
#include "barreno/arenisca/parts/shear_limit.hpp"
#include "barreno/arenisca/parts/tension.hpp"

#ifdef BARRENO_OUTSIDE_PARTS
// Parts of a program that builds the library with parts of its own (docs/extending.md).
#include BARRENO_OUTSIDE_PARTS
#else
namespace barreno::arenisca::outside {
using ShearLimits = PartList<>;
using CrushCurves = PartList<>;
using FlowRules = PartList<>;
}  // namespace barreno::arenisca::outside
#endif

namespace barreno::arenisca {

// The lists of parts that a card may ask for instead of the published ones: the one line that a new
// part adds. Such a part says, besides what every part does, by which word its form is known and
// whether a card asks for it (`word`, `asked`).
using OtherShearLimits = JoinedLists<PartList<>, outside::ShearLimits>::type;
using OtherCrushCurves = JoinedLists<PartList<>, outside::CrushCurves>::type;
using OtherFlowRules = JoinedLists<PartList<>, outside::FlowRules>::type;
using OtherParts =
    JoinedLists<OtherShearLimits, JoinedLists<OtherCrushCurves, OtherFlowRules>::type>::type;

/// All parts, in the order of the manual.
using AllParts = JoinedLists<
    PartList<
        ShearLimit,
        FlowRule,
        Elasticity,
        CrushCurve,
        CapShape,
        Accuracy,
        Fluid,
        Rate,
        Lode,
        Weibull,
        Damage,
        Tension,
        Breakage,
        Heat>,
    OtherParts>::type;

/// The parts that a form may exchange.
template <class ShearLimit_, class CrushCurve_, class FlowRule_>
struct PartsOf {
  using ShearLimit = ShearLimit_;
  using CrushCurve = CrushCurve_;
  using FlowRule = FlowRule_;
};
using PublishedParts = PartsOf<ShearLimit, CrushCurve, FlowRule>;

}  // namespace barreno::arenisca
