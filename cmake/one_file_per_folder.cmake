# For builds that are made in whole, not for those in which people work: headers cost more than all else.
option(BARRENO_TOGETHER "Compile the sources of each folder, and those of each test program, as one file" OFF)

# Compiles the sources of each folder of a target as one file, which takes half of the time. Apart stay files with names of their own
# that another file of their folder has too (the compiler then says "redefinition": add it to the list), and the one
# that tests/fuzz replaces.
function(barreno_one_file_per_folder target root)  # and the target's sources, paths below root
  foreach(source IN LISTS ARGN)
    get_filename_component(folder ${source} DIRECTORY)
    string(REPLACE "/" "_" folder "folder_${folder}")
    set_source_files_properties(${root}/${source} PROPERTIES UNITY_GROUP ${folder})
  endforeach()
  foreach(source base/machine_bytes deck/fidelity drive/matrix geometry/shape geometry/surface scene/scene_contact
          scene/scene_loads scene/scene_pressures step/transfer/project_particles step/nodes/solve_velocity)
    set_source_files_properties(${root}/${source}.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
