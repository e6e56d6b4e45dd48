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

/// Machines like this one that the ranks are on, or will be; one until it is set.
int machines();
void set_machines(int count);

/// Of the ranks of MPI_COMM_WORLD, which is set up. Collective.
int count_machines();

}  // namespace barreno
