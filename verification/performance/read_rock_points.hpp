// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "materials/arenisca_points.hpp"

#include <string>
#include <vector>

namespace barreno {

/// Recorded point updates, see record_rock_points.cpp.
struct RecordedPoints {
  std::vector<test::RockPoint> flowing, elastic;
};

/// @throws std::runtime_error if there is no such file or a line is not as it was written
RecordedPoints read_rock_points(const std::string& file);

}  // namespace barreno
