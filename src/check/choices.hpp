// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <string>

namespace barreno {

/// Whether something is part of a run, and why.
struct Choice {
  bool on = false;
  std::string why;
};

/// Whether pore fluid drains: how far pressure diffuses in the run, and who decided.
Choice pore_flow_choice(const Scene& scene);

/// Whether dormant tiles are skipped, or why not.
Choice dormancy_choice(const Scene& scene);

/// Whether inertia is scaled: by how much, and how fast that is beside diffusion.
Choice quasi_static_choice(const Scene& scene);
Choice refinement_choice(const Scene& scene);

}  // namespace barreno
