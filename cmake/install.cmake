# What cmake --install adds to the material library (materials/CMakeLists.txt): the commands, the program, decks, Python
# packages, documents, manual pages and bash completion. The prefix may be moved as a whole.
set(libexec ${CMAKE_INSTALL_LIBEXECDIR})
set(data ${CMAKE_INSTALL_DATADIR})
file(RELATIVE_PATH barreno_bin_to_data /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${data})
file(RELATIVE_PATH barreno_bin_to_libexec /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${libexec})
file(RELATIVE_PATH barreno_bin_to_lib /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${CMAKE_INSTALL_LIBDIR})
configure_file(${PROJECT_SOURCE_DIR}/src/installed.sh.in ${CMAKE_CURRENT_BINARY_DIR}/installed.sh @ONLY)
install(PROGRAMS ${CMAKE_CURRENT_BINARY_DIR}/installed.sh DESTINATION ${CMAKE_INSTALL_BINDIR} RENAME barreno)
install(FILES ${PROJECT_SOURCE_DIR}/src/commands.sh DESTINATION ${data}/barreno)
install(TARGETS barreno barreno_multigrid RUNTIME DESTINATION ${libexec}/barreno LIBRARY DESTINATION ${libexec}/barreno)
# What was measured of costs and depths (src/files/measured_table.hpp).
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/measured/ DESTINATION ${data}/barreno/measured FILES_MATCHING PATTERN "*.csv")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/input_xml DESTINATION ${data}/barreno)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
  ${PROJECT_SOURCE_DIR}/CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.md")
# Manual pages and completion are made of what the installed commands say of themselves with --help.
install(CODE "
  set(barreno_prefix \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\")
  execute_process(COMMAND \"${BARRENO_PYTHON}\" \"${PROJECT_SOURCE_DIR}/cmake/write_manual.py\"
      \"\${barreno_prefix}/${CMAKE_INSTALL_BINDIR}/barreno\"
      \"\${barreno_prefix}/${CMAKE_INSTALL_MANDIR}/man1\" \"\${barreno_prefix}/${data}/bash-completion/completions\"
    RESULT_VARIABLE barreno_failed)
  if(barreno_failed)
    message(WARNING \"No manual pages and no completion: ${BARRENO_PYTHON} or the installed program does not start (see above); name a Python with -D BARRENO_PYTHON=...\")
  endif()")
