// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace barreno {

/// What --version prints: of this code its version and commit, of what it was built with compiler
/// and libraries; a line each.
std::string version_text();

}  // namespace barreno
