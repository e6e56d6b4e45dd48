// SPDX-License-Identifier: BSD-3-Clause
#include "base/process.hpp"

#include <mpi.h>

#include <ctime>
#include <sys/resource.h>

namespace barreno {
namespace {

int machines_of_ranks = 1;

}  // namespace

double peak_resident_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  constexpr double kibibyte = 1024.0;  // the unit of ru_maxrss on Linux
  return kibibyte * static_cast<double>(usage.ru_maxrss);
}

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

int machines() {
  return machines_of_ranks;
}

void set_machines(int count) {
  machines_of_ranks = count;
}

int count_machines() {
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  int rank = 0;
  MPI_Comm_rank(machine, &rank);
  MPI_Comm_free(&machine);
  int first = rank == 0 ? 1 : 0, count = 0;
  MPI_Allreduce(&first, &count, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  return count;
}

}  // namespace barreno
