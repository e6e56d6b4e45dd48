// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jet/depth.hpp"
#include "jet/estimate.hpp"

namespace barreno {

/// The jet breaks, and its particles are divided as often as in the shots with which the error of
/// such jets was measured (docs/trade.md, Depth at rest). Its metal does not pile up then, so the
/// error is not that of jets whose particles stay whole.
bool is_divided(const Scene& scene);

/// Depth at rest of the hole of such a jet over that of hydrodynamic theory (estimate_jet()):
/// perforation.xml has 543 to 586 mm as wide as the jet, by the size of the cells, and 265 mm by
/// the theory (docs/trade.md, Depth at rest). For predictions of the end of a run alone.
inline constexpr double divided_depth_ratio = 2.1;

/// What the cells do to the depth of such a jet. A thread of spent metal goes on when the hole as
/// wide as the jet no longer grows: the error is known until a time, and of a run that ends at
/// rest (Scene::at_rest). That of Penetration::probed_depth is known of any time.
DepthDoubt divided_depth_doubt(
    const Scene& scene, double time, const DepthTables& tables = depth_tables()
);

/// What they do to Penetration::probed_depth of a run; unknown of all jets but these.
DepthDoubt probed_depth_doubt(
    const Scene& scene,
    double time,
    const Penetration& found,
    const DepthTables& tables = depth_tables()
);

/// What they do to the volume of the hole (channel_volume()) of a run; unknown of all jets but
/// these.
DepthDoubt volume_doubt(
    const Scene& scene,
    double time,
    const Penetration& found,
    const DepthTables& tables = depth_tables()
);

/// What they do to the core flow efficiency of the hole of a run that has come to rest, fed from
/// the side of the rock (`barreno flow`); unknown of all jets but these, and of rock whose
/// grains or bonds break otherwise.
DepthDoubt efficiency_doubt(
    const Scene& scene,
    double time,
    const Penetration& found,
    const DepthTables& tables = depth_tables()
);

}  // namespace barreno
