# The suite with the sanitized build. Two of its tests are in every run; the others are in ctest's configuration
# Sanitized (ctest -C Sanitized -L sanitized), so that asking for a test by its name does not build them all.
# Open MPI and Trilinos keep memory to the end, so leaks are not counted.
set(sanitized_environment ${mpi_environment} "ASAN_OPTIONS=detect_leaks=0:verify_asan_link_order=0" UBSAN_OPTIONS=print_stacktrace=1)

# barreno_sanitized_script(NAME LABELS SCRIPT ...): a script of the decks with the sanitized program.
function(barreno_sanitized_script NAME LABELS SCRIPT)
  set(test sanitized.${NAME})
  set(only)
  if(LABELS STREQUAL slow)
    set(only CONFIGURATIONS Sanitized)
  endif()
  add_test(NAME ${test} COMMAND ${BARRENO_PYTHON} ${SCRIPT} $<TARGET_FILE:barreno_sanitized> ${ARGN} ${only})
  set_tests_properties(${test} PROPERTIES LABELS "sanitized;${LABELS}" TIMEOUT 3600 ENVIRONMENT "${sanitized_environment}")
endfunction()

# The unit tests, built when the suite is run. Not step.allocations: it takes the place of malloc, as the sanitizer does.
add_custom_target(sanitized_tests)
add_library(test_support_sanitized STATIC EXCLUDE_FROM_ALL support/scenes.cpp main.cpp)
target_include_directories(test_support_sanitized PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_compile_definitions(test_support_sanitized PUBLIC $<TARGET_PROPERTY:barreno_core,INTERFACE_COMPILE_DEFINITIONS>)
target_link_libraries(test_support_sanitized PUBLIC core_sanitized materials_sanitized GTest::gtest)
set_target_properties(test_support_sanitized PROPERTIES EXPORT_COMPILE_COMMANDS OFF)
get_property(names GLOBAL PROPERTY barreno_unit_tests)
list(REMOVE_ITEM names step.allocations)
foreach(name IN LISTS names)
  get_property(sources GLOBAL PROPERTY barreno_sources_of_${name})
  string(REPLACE "." "_" target "sanitized_${name}")
  add_executable(${target} EXCLUDE_FROM_ALL ${sources})
  set_target_properties(${target} PROPERTIES EXPORT_COMPILE_COMMANDS OFF RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests/sanitized)
  target_link_libraries(${target} PRIVATE test_support_sanitized)
  target_compile_definitions(${target} PRIVATE BARRENO_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  add_dependencies(sanitized_tests ${target})
  get_property(all_ranks GLOBAL PROPERTY barreno_ranks_of_${name})
  foreach(ranks IN LISTS all_ranks)
    set(test sanitized.${name}.np${ranks})
    if(ranks EQUAL 1)
      add_test(NAME ${test} COMMAND ${target} CONFIGURATIONS Sanitized)
    else()
      add_test(NAME ${test} COMMAND ${MPIEXEC_EXECUTABLE} -n ${ranks} $<TARGET_FILE:${target}> CONFIGURATIONS Sanitized)
    endif()
    set_tests_properties(${test} PROPERTIES LABELS "sanitized;slow" TIMEOUT 3600 PROCESSORS ${ranks}
      ENVIRONMENT "${sanitized_environment}" FIXTURES_REQUIRED sanitized_tests)
  endforeach()
endforeach()
add_test(NAME sanitized.build COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR} --target sanitized_tests CONFIGURATIONS Sanitized)
set_tests_properties(sanitized.build PROPERTIES LABELS "sanitized;slow" TIMEOUT 7200 PROCESSORS 2 FIXTURES_SETUP sanitized_tests)

# What every run of the tests has: all decks, and what a run leaves for the next.
barreno_sanitized_script(runs mpi ${CMAKE_CURRENT_SOURCE_DIR}/sanitized/test_runs.py)
# One rank: sanitized.orders.
barreno_sanitized_script(shipped_decks deck ${CMAKE_CURRENT_SOURCE_DIR}/decks/test_shipped_decks.py --ranks 2 --coarse)
set_tests_properties(sanitized.runs sanitized.shipped_decks PROPERTIES PROCESSORS 2 COST 100)
# Every deck once, with orders of the step, transfers and shape functions in turn; all with all under slow.
set(orders ${CMAKE_CURRENT_SOURCE_DIR}/sanitized/test_orders.py $<TARGET_FILE_DIR:barreno>/../verification)
add_test(NAME sanitized.orders COMMAND ${BARRENO_PYTHON} ${orders})
add_test(NAME slow.sanitized_orders COMMAND ${BARRENO_PYTHON} ${orders} --all)
set_tests_properties(sanitized.orders PROPERTIES LABELS "sanitized;deck" TIMEOUT 900 ENVIRONMENT "${sanitized_environment}")
set_tests_properties(slow.sanitized_orders PROPERTIES LABELS slow TIMEOUT 20000 ENVIRONMENT "${sanitized_environment}")
# With the cells that the largest decks have.
barreno_sanitized_script(shipped_decks_as_they_are slow ${CMAKE_CURRENT_SOURCE_DIR}/decks/test_shipped_decks.py --ranks 2)
foreach(script bad_decks bad_particles clipped_domains drive file_sets pore_flow quick_perforation resume rigid_shapes)
  barreno_sanitized_script(${script} slow ${CMAKE_CURRENT_SOURCE_DIR}/decks/test_${script}.py)
endforeach()
