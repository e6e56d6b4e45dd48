// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/sections/detonation_section.hpp"
#include "deck/sections/grid_section.hpp"
#include "scene/scene.hpp"

namespace barreno {

/// Whether a body burns.
bool is_explosive(const Scene& scene, const BodySpec& body);

/// The point of a detonator that is nearest to x. In axisymmetry all is in the half plane, where a
/// ring is a point.
Vector nearest_point(const DetonatorSpec& detonator, Mode mode, const Vector& x);

/// When the front comes to x if nothing is in its way: the least of
///
///   t = t_d + |x - nearest point of the detonator| / D
///
/// over the detonators [time].
double straight_lighting_time(const DetonationSpec& detonation, Mode mode, const Vector& x);

/// The same by the way that the deck asks for; infinite where no front comes.
double lighting_time(const DetonationSpec& detonation, Mode mode, const Vector& x);

}  // namespace barreno
