// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

constexpr double pi = 3.14159265358979323846;

}  // namespace barreno
