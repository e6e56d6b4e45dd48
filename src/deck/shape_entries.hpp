// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <barreno/input/schema.hpp>
#include <string>
#include <vector>

namespace barreno {

/// The parameters that say a shape, for every list that has one. Which of them a shape takes in
/// which mode is a rule of the scene.
/// @param shape  the word that Shape defaults to; empty: it must be given
std::vector<input::Entry> shape_entries(const std::string& shape);

}  // namespace barreno
