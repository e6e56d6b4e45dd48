# Headers of the libraries, precompiled: nearly every file reads them, and that takes longer than to compile most files.
# barreno_precompile(TARGET and what target_precompile_headers takes). clang-tidy reads files without them
# (tests/style/check_tidy.py).
option(BARRENO_PRECOMPILED "Precompile the headers of the libraries" ON)

set(barreno_library_headers <algorithm> <array> <cmath> <map> <memory> <string> <variant> <vector>
  <Kokkos_Core.hpp> <Teuchos_Comm.hpp>)
function(barreno_precompile target)
  if(BARRENO_PRECOMPILED)
    target_precompile_headers(${target} ${ARGN})
    # for ccache, which reads what gcc preprocesses
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  endif()
endfunction()
