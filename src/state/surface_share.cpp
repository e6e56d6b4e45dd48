// SPDX-License-Identifier: BSD-3-Clause
#include "state/surface_share.hpp"

#include "base/numbers.hpp"
#include "scene/geometry.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {

SurfaceShare surface_share(
    const Ball& ball, BallSurface surface, const Vector& point, int dimensions
) {
  SurfaceShare share;
  if (!(ball.inner_radius > 0.0)) {
    share.value = surface == BallSurface::outer ? 1.0 : 0.0;
    return share;
  }
  Vector arm{};
  double square = 0.0;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d) {
    arm[d] = point[d] - ball.centre[d];
    square += arm[d] * arm[d];
  }
  const double radius = std::sqrt(square);
  const double width = std::min(ball.radius - ball.inner_radius, ball.inner_radius);
  const double s = std::clamp((radius - ball.inner_radius) / width, 0.0, 1.0);
  const double outer = s * s * (3.0 - 2.0 * s);
  const double sign = surface == BallSurface::outer ? 1.0 : -1.0;
  share.value = surface == BallSurface::outer ? outer : 1.0 - outer;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d)
    share.gradient[d] = sign * 6.0 * s * (1.0 - s) / width * arm[d] / radius;
  return share;
}

double cavity_volume(const Ball& ball, const GridSpec& grid) {
  const double a = ball.inner_radius;
  const bool sphere = grid.mode == Mode::axisymmetric || dimensions(grid.mode) == 3;
  const double whole = sphere ? 4.0 / 3.0 * pi * a * a * a : pi * a * a;
  int cuts = 0;
  for (const Face face : cutting_faces(ball, grid)) {
    const bool axis = grid.mode == Mode::axisymmetric && face == Face::x_lower;
    cuts += axis ? 0 : 1;  // the rings go round the axis
  }
  return std::ldexp(whole, -cuts);
}

bool is_on_surfaces(const PressureLoadSpec& load) {
  return load.surfaces[0] || load.surfaces[1];
}

}  // namespace barreno
