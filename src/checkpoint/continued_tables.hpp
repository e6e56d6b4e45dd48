// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/run_numbers.hpp"
#include "checkpoint/find_checkpoint.hpp"
#include "scene/scene.hpp"
#include "state/continued.hpp"

#include <string>

namespace barreno {

/// What a run took over (Continued) as tables of its checkpoints: group `continued`, and the names
/// of the bodies, a line each.
RunNumbers numbers_of(const Continued& continued);
std::string names_of(const Continued& continued);

/// The same read from a checkpoint, with every value looked at. @throws FileError
Continued read_continued(const Scene& scene, const Checkpoint& checkpoint);

}  // namespace barreno
