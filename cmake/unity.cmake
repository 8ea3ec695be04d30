# Most of the time that a file takes to compile is its headers': templates of the standard library, fmt and JSON, made anew for
# every file. So the files of one folder are compiled as one, in a third of the time. What that asks of them: names in anonymous
# namespaces are distinct within a folder of lib. Who edits much sets -D RAYLAB_UNITY=OFF, and compiles only what changes.
option(RAYLAB_UNITY "Compile the library's files folder by folder" ON)

# raylab_unity(<target> <file>...): files with options of their own are left alone, as CMake does.
function(raylab_unity target)
  if(NOT RAYLAB_UNITY)
    return()
  endif()
  foreach(file IN LISTS ARGN)
    cmake_path(RELATIVE_PATH file BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" OUTPUT_VARIABLE folder)
    cmake_path(GET folder PARENT_PATH folder)
    string(MAKE_C_IDENTIFIER "${folder}" group)
    set_source_files_properties("${file}" PROPERTIES UNITY_GROUP "${group}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
