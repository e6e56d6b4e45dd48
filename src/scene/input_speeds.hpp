// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

namespace barreno {

/// Speeds that a deck puts into a scene [length/time].

/// What a body's spin gives its corners, at most.
double rim_speed(const BodySpec& body, const GridSpec& grid);
/// What a body starts with, at most.
double body_speed(const BodySpec& body, const GridSpec& grid);
/// Of a body whose motion is prescribed, at any time.
double motion_speed(const MotionSpec& motion);
/// Of a face of the grid that moves, at any time.
double face_speed(const ConditionSpec& condition);

/// The largest of bodies, jet and moving faces; 0 where all motion comes from forces.
double largest_input_speed(const Scene& scene);

}  // namespace barreno
