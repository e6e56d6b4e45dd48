// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

/// Most memory that this process has used so far [bytes].
double peak_resident_bytes();

/// Time of processors that this process has taken so far [s]: other work on the machine does not
/// count.
double cpu_seconds();

/// Memory of this machine [bytes].
double machine_bytes();

}  // namespace barreno
