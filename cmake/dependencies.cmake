# Third-party packages as one INTERFACE target each; a missing one is one sentence with the Debian package.

find_package(MPI COMPONENTS C CXX QUIET)
if(NOT MPI_CXX_FOUND)
  message(FATAL_ERROR "Open MPI is missing: install the packages libopenmpi-dev and openmpi-bin.")
endif()

find_package(Trilinos QUIET COMPONENTS Teuchos Kokkos Tpetra Belos Ifpack2 MueLu)
if(NOT Trilinos_FOUND)
  message(FATAL_ERROR "Trilinos is missing: install the packages trilinos-all-dev, libptscotch-dev and libscotch-dev.")
endif()
if(BARRENO_DEVICE_TRILINOS AND NOT "${Kokkos_DEVICES}" MATCHES "CUDA|HIP|SYCL|OPENMPTARGET|OPENACC")
  message(FATAL_ERROR "The Kokkos of BARRENO_DEVICE_TRILINOS ('${BARRENO_DEVICE_TRILINOS}') has no device backend "
    "(${Kokkos_DEVICES}); give a Trilinos that has one, or take the preset release.")
endif()
add_library(barreno_trilinos INTERFACE)
if(TARGET Trilinos::all_libs)
  target_link_libraries(barreno_trilinos INTERFACE Trilinos::all_libs)
else()
  target_include_directories(barreno_trilinos SYSTEM INTERFACE
    ${Trilinos_INCLUDE_DIRS} ${Trilinos_TPL_INCLUDE_DIRS})
  target_link_directories(barreno_trilinos INTERFACE ${Trilinos_LIBRARY_DIRS})
  target_link_libraries(barreno_trilinos INTERFACE ${Trilinos_LIBRARIES} ${Trilinos_TPL_LIBRARIES})
endif()
target_link_libraries(barreno_trilinos INTERFACE MPI::MPI_CXX)
# The deprecated C++ binding of MPI is not used, and its header warns.
target_compile_definitions(barreno_trilinos INTERFACE OMPI_SKIP_MPICXX)
target_link_options(barreno_trilinos INTERFACE -Wl,--as-needed)

# The parallel HDF5, the one that Debian's Exodus is built on; never the serial one beside it.
set(HDF5_PREFER_PARALLEL TRUE)
find_package(HDF5 QUIET COMPONENTS C)
if(NOT HDF5_FOUND OR NOT HDF5_IS_PARALLEL)
  message(FATAL_ERROR "The parallel HDF5 is missing: install the package libhdf5-openmpi-dev.")
endif()
# CRC-32 of whole checkpoints: that of zlib, several times as fast.
find_library(BARRENO_LIBDEFLATE NAMES deflate)
find_path(BARRENO_LIBDEFLATE_INCLUDE libdeflate.h)
if(NOT BARRENO_LIBDEFLATE OR NOT BARRENO_LIBDEFLATE_INCLUDE)
  message(FATAL_ERROR "libdeflate is missing: install the package libdeflate-dev.")
endif()
add_library(barreno_hdf5 INTERFACE)
target_include_directories(barreno_hdf5 SYSTEM INTERFACE ${HDF5_INCLUDE_DIRS} ${BARRENO_LIBDEFLATE_INCLUDE})
target_link_libraries(barreno_hdf5 INTERFACE ${HDF5_LIBRARIES} ${BARRENO_LIBDEFLATE})
find_library(BARRENO_EXODUS_LIBRARY NAMES exodus exoIIv2c)
find_path(BARRENO_EXODUS_INCLUDE exodusII.h)
if(NOT BARRENO_EXODUS_LIBRARY OR NOT BARRENO_EXODUS_INCLUDE)
  message(FATAL_ERROR "Exodus is missing: install the package libexodusii-dev.")
endif()
add_library(barreno_exodus INTERFACE)
target_include_directories(barreno_exodus SYSTEM INTERFACE ${BARRENO_EXODUS_INCLUDE})
target_link_libraries(barreno_exodus INTERFACE ${BARRENO_EXODUS_LIBRARY})

# The reader of STL files, headers only, in those parts of CGAL that are under the LGPL. Its own CMake target is left
# aside: it would compile everything with -frounding-math.
find_path(BARRENO_CGAL_INCLUDE CGAL/IO/STL.h)
if(NOT BARRENO_CGAL_INCLUDE)
  message(FATAL_ERROR "CGAL is missing: install the package libcgal-dev.")
endif()
add_library(barreno_cgal INTERFACE)
target_include_directories(barreno_cgal SYSTEM INTERFACE ${BARRENO_CGAL_INCLUDE})
