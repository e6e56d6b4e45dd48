# A path that does not exist would be passed over without a word, and the system's Trilinos, for processors, be found
# instead.
set(BARRENO_DEVICE_TRILINOS "" CACHE PATH "Folder with the TrilinosConfig.cmake of a Trilinos whose Kokkos has a device backend")
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
