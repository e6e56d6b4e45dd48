// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

/// Most memory that this process has held so far [bytes].
double peak_resident_bytes();

/// Memory of this machine [bytes].
double machine_bytes();

}  // namespace barreno
