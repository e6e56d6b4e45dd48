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

BuildFacts build_facts() {
  const int kokkos = KOKKOS_VERSION;
  const std::string number = std::to_string(kokkos / 10000) + "." +
                             std::to_string(kokkos / 100 % 100) + "." +
                             std::to_string(kokkos % 100);
  return {
      {"commit", BARRENO_COMMIT},
      {"compiler", BARRENO_COMPILER},
      {"Trilinos", TRILINOS_VERSION_STRING},
      {"Kokkos", number + ", " + Kokkos::DefaultExecutionSpace::name()},
      {"MPI", mpi_version()}};
}

std::string version_text() {
  constexpr std::size_t width = 12;
  std::string text = std::string("barreno ") + BARRENO_VERSION + "\n";
  for (const auto& [name, value] : build_facts())
    text.append(name).append(width - name.size(), ' ').append(value).append("\n");
  return text;
}

}  // namespace barreno
