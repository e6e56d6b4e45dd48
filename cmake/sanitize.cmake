# What a sanitized target is compiled with. Left out is what doubles the compiling (null, alignment and size checks; the
# use of a local variable after its block, which the guided build of the readers has) and what the address sanitizer or
# the processor stops anyway. Every index into a container or a field is checked.
set(barreno_sanitizers address,undefined,float-cast-overflow)
function(barreno_sanitize target kind)  # kind: PUBLIC or INTERFACE
  target_compile_definitions(${target} ${kind} _GLIBCXX_ASSERTIONS KOKKOS_ENABLE_DEBUG_BOUNDS_CHECK)
  target_compile_options(${target} ${kind} -g1 -O1 -fno-omit-frame-pointer -fsanitize=${barreno_sanitizers}
    -fno-sanitize=vptr,null,alignment,object-size -fno-sanitize-recover=all
    $<IF:$<BOOL:${BARRENO_GUIDED}>,-fsanitize=fuzzer-no-link,-fno-sanitize-address-use-after-scope>)
  target_link_options(${target} ${kind} -fsanitize=${barreno_sanitizers})
endfunction()
