// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

namespace barreno {

constexpr double pi = 3.14159265358979323846;
constexpr double two_pi = 2.0 * pi;
constexpr double speed_of_light = 299792458.0;  ///< [length/time]
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace barreno
