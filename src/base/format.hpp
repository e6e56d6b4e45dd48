// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace barreno {

/// printf into a string, for lines whose columns must line up; cut after 255 characters.
std::string format(const char* pattern, ...) __attribute__((format(printf, 1, 2)));

}  // namespace barreno
