// SPDX-License-Identifier: BSD-3-Clause
#include "base/start_mpi.hpp"

#include <Tpetra_Core.hpp>

#include <gtest/gtest.h>
#include <mpi.h>

/// Every test program runs under MPI and Kokkos; it fails if any rank fails.
int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  barreno::prepare_lone_mpi();
  const Tpetra::ScopeGuard guard(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank != 0) {
    auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
  }
  const int mine = RUN_ALL_TESTS();
  int any = 0;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  if (any != 0 && rank == 0 && mine == 0) std::printf("a test failed on another rank\n");
  if (any == 0 && ::testing::UnitTest::GetInstance()->test_to_run_count() == 0) {
    if (rank == 0) std::printf("no test ran\n");
    return 1;
  }
  return any;
}
