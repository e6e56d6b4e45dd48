// SPDX-License-Identifier: BSD-3-Clause
/// Leaves over what count_messages must see, on two ranks: a message that nobody receives, a
/// receive that nobody sends for, a communicator; one message is sound.
#include <mpi.h>

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int rank = 0, value = 1, nothing = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm comm = MPI_COMM_NULL;
  MPI_Comm_dup(MPI_COMM_WORLD, &comm);
  MPI_Request open = MPI_REQUEST_NULL;
  if (rank == 0) {
    MPI_Send(&value, 1, MPI_INT, 1, 1, comm);
    MPI_Send(&value, 1, MPI_INT, 1, 2, comm);
  } else {
    MPI_Irecv(&value, 1, MPI_INT, 0, 1, comm, &open);
    MPI_Wait(&open, MPI_STATUS_IGNORE);
    MPI_Irecv(&nothing, 1, MPI_INT, 0, 3, comm, &open);
  }
  MPI_Finalize();
}
