// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

/// Memory bandwidth of one process by the triad a = b + s c over arrays far larger than the cache:
/// the best of five, 24 bytes counted per element [byte/s].
double measure_triad();

}  // namespace barreno
