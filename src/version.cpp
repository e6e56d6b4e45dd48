// SPDX-License-Identifier: BSD-3-Clause
#include "version.hpp"

#include "commit.hpp"  // of the build folder: cmake/write_commit.cmake

#include <Kokkos_Core.hpp>

#include <mpi.h>

#include <Trilinos_version.h>

namespace barreno {
namespace {

/// Of the library that runs, which need not be the one that was built with.
std::string mpi_version() {
  char text[MPI_MAX_LIBRARY_VERSION_STRING];
  int length = 0;
  MPI_Get_library_version(text, &length);
  const std::string all(text, static_cast<std::size_t>(length));
  return all.substr(0, all.find(','));
}

}  // namespace

std::string version_text() {
  const int kokkos = KOKKOS_VERSION;
  return std::string("barreno ") + BARRENO_VERSION + "\n" + "commit      " + BARRENO_COMMIT + "\n" +
         "compiler    " + BARRENO_COMPILER + "\n" + "Trilinos    " + TRILINOS_VERSION_STRING +
         "\n" + "Kokkos      " + std::to_string(kokkos / 10000) + "." +
         std::to_string(kokkos / 100 % 100) + "." + std::to_string(kokkos % 100) + ", " +
         Kokkos::DefaultExecutionSpace::name() + "\n" + "MPI         " + mpi_version() + "\n";
}

}  // namespace barreno
