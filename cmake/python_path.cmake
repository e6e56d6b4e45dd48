# Where the scripts of tests and verification find what they import: the package barreno, and the folders of each other.
set(barreno_python_path ${PROJECT_SOURCE_DIR}/src/python ${PROJECT_SOURCE_DIR}/verification ${PROJECT_SOURCE_DIR}/tests/scripts
  ${PROJECT_SOURCE_DIR}/tests/unit ${PROJECT_SOURCE_DIR}/tests/unit/report ${PROJECT_SOURCE_DIR}/tests/layout
  ${PROJECT_SOURCE_DIR}/input_xml/jets)
list(JOIN barreno_python_path ":" barreno_python_path)

# Of all tests of the folder that calls it, at its end.
function(barreno_set_python_path)
  get_property(names DIRECTORY PROPERTY TESTS)
  set_property(TEST ${names} APPEND PROPERTY ENVIRONMENT "PYTHONPATH=${barreno_python_path}")
endfunction()
