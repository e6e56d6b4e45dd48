// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <string>

namespace barreno {

/// A warning that the jet will meet no body, or none before the end of the run, so that there will
/// be no depth. Empty if it will, or if there is no jet.
std::string jet_note(const Scene& scene);

}  // namespace barreno
