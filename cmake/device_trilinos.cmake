# A path that does not exist would be passed over without a word, and the system's Trilinos, for processors, be found
# instead.
set(BARRENO_DEVICE_TRILINOS "" CACHE PATH "Folder with the TrilinosConfig.cmake of a Trilinos whose Kokkos has a device backend")
option(BARRENO_DEVICE "Build for a device, which is not supported yet (docs/development.md)" OFF)
if(BARRENO_DEVICE AND NOT BARRENO_DEVICE_TRILINOS)
  message(FATAL_ERROR "The preset gpu needs a Trilinos whose Kokkos has a device backend (docs/development.md, Devices); "
    "name the folder of its TrilinosConfig.cmake in the environment variable BARRENO_DEVICE_TRILINOS.")
endif()
if(BARRENO_DEVICE_TRILINOS)
  if(NOT EXISTS "${BARRENO_DEVICE_TRILINOS}/TrilinosConfig.cmake")
    message(FATAL_ERROR "BARRENO_DEVICE_TRILINOS names '${BARRENO_DEVICE_TRILINOS}', which holds no TrilinosConfig.cmake; "
      "give the folder lib/cmake/Trilinos of a Trilinos whose Kokkos has a device backend.")
  endif()
  set(Trilinos_DIR "${BARRENO_DEVICE_TRILINOS}" CACHE PATH "" FORCE)
  # Its other packages stand beside it.
  get_filename_component(device_prefix "${BARRENO_DEVICE_TRILINOS}/../../.." ABSOLUTE)
  list(PREPEND CMAKE_PREFIX_PATH "${device_prefix}")
endif()
