// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <string>

namespace barreno {

/// A warning that the jet will meet no body, or none before the end of the run, so that there will
/// be no depth, or that most of it passes by. Empty if it will, or if there is no jet.
std::string jet_note(const Scene& scene);

/// A warning that the run ends while a share of the jet worth naming still digs or flies. Empty if
/// it does not, or if the jet does not reach the target at all.
std::string early_end_note(const Scene& scene);

/// A warning that the jet will be through the target, which has no depth then. Empty if it will
/// not.
std::string through_note(const Scene& scene);

/// A warning that late discs of a metal that breaks are cut into too few layers of particles to
/// flow aside at the bottom of their hole (docs/trade.md, Depth at rest). Empty if they are not.
std::string thin_slugs_note(const Scene& scene);

}  // namespace barreno
