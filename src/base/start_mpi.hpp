// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

/// Whether mpirun, or a scheduler, has started this process as one of its ranks.
bool is_rank();

/// Before MPI_Init of a process that nobody has started as a rank: Open MPI then starts no daemon,
/// makes no folder and looks for no network, which is half the time of a start. What the
/// environment sets stays, but for the ways to other ranks.
void prepare_lone_mpi();

}  // namespace barreno
