// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jet/depth.hpp"
#include "scene/scene.hpp"
#include "state/host_particles.hpp"

#include <vector>

namespace barreno {

/// Distance of the wall from the axis, in rows of one cell from the outer face to the rear of the
/// target; the width of the grid where there is none. Collective. [length]
std::vector<double> wall_radii(
    const std::vector<HostParticles>& sets,
    const Scene& scene,
    const JetPath& path,
    const Comm& comm
);

/// Open channel from the wall of every row: its depth, and its radius in the middle.
void measure_channel(const std::vector<double>& radii, const JetPath& path, Penetration& result);

/// Distance of the wall from the axis at a depth of the open channel; 0 without one [length].
double wall_at(const JetPath& path, const Penetration& found, double depth);

/// Diameter of the hole (plane strain: its width) in the first whole row behind the front face of a
/// layer; 0 where it is closed there [length].
double entrance_diameter(const PathLayer& layer, const JetPath& path, const Penetration& found);

/// Volume of the open channel from the walls of its rows; a row without a wall, in a gap between
/// bodies, has none. The whole circle, in plane strain per thickness [length^3].
double channel_volume(const GridSpec& grid, const JetPath& path, const Penetration& found);

/// The same down to its probed_depth, crumbs and necks included: of the hole that is as wide as the
/// jet, without the thread behind it [length^3].
double probed_volume(const GridSpec& grid, const JetPath& path, const Penetration& found);

}  // namespace barreno
