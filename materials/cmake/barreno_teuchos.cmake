# SPDX-License-Identifier: BSD-3-Clause
# barreno::teuchos: Trilinos' parameter lists as one imported target, after find_package(TeuchosParameterList).
if(NOT TARGET barreno::teuchos)
  add_library(barreno::teuchos INTERFACE IMPORTED GLOBAL)
  set_target_properties(barreno::teuchos PROPERTIES
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${TeuchosParameterList_INCLUDE_DIRS}"
    INTERFACE_INCLUDE_DIRECTORIES "${TeuchosParameterList_INCLUDE_DIRS}"
    INTERFACE_LINK_LIBRARIES "${TeuchosParameterList_LIBRARIES}")
endif()
