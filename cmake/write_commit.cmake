# Writes FILE with the commit of the tree in ROOT, where git and its folder are there:
#   cmake -D ROOT=... -D FILE=... -P write_commit.cmake
find_program(GIT git)
set(commit "unknown")
if(NOT "$ENV{BARRENO_COMMIT}" STREQUAL "")
  set(commit "$ENV{BARRENO_COMMIT}")  # where the tree comes without .git
endif()
if(GIT)
  execute_process(COMMAND ${GIT} -C ${ROOT} rev-parse --short=12 HEAD
    OUTPUT_VARIABLE said OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    set(commit ${said})
  endif()
endif()
file(WRITE ${FILE} "#define BARRENO_COMMIT \"${commit}\"\n")
