// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/build_facts.hpp"

#include <string>

namespace barreno {

/// Of what the program was built: commit, compiler, Trilinos, Kokkos and the MPI that runs.
BuildFacts build_facts();

/// What --version prints: of this code its version and commit, of what it was built with compiler
/// and libraries; a line each.
std::string version_text();

}  // namespace barreno
