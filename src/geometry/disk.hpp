// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace barreno {

struct Rectangle {
  std::array<double, 2> lower{}, upper{};
};
/// Area and first moments about the centre of the disk.
struct DiskMoments {
  double area = 0.0, x = 0.0, y = 0.0;
};

/// What a disk around the origin fills of a rectangle, in closed form.
DiskMoments disk_moments(double radius, const Rectangle& rectangle);

}  // namespace barreno
