// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/split_scales.hpp"
#include "scene/scene.hpp"

namespace barreno {

/// What a particle of a set may bring into the ledger, about: sums over rows split numbers by it.
struct TallyScales {
  SplitScales mass, momentum, energy;
};

/// Of a cell full of the material, at its speed of sound; from the scene alone, so that it is the
/// same on all ranks and after a resume.
TallyScales tally_scales(const Scene& scene, int material);

}  // namespace barreno
