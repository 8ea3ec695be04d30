# Target headers_alone: every header compiles by itself, so that nobody has to know what to include before it. Only the precompiled
# headers of the standard library, GLM and fmt stand before it here, as they do in every file.

# raylab_headers_alone(<folder> <header>...)
function(raylab_headers_alone folder)
  # Of a header that another one includes first, nothing needs to be compiled: nothing stands before it there.
  set(headers ${ARGN})
  foreach(header IN LISTS ARGN)
    file(STRINGS "${header}" first REGEX "^ *# *include" LIMIT_COUNT 1)
    if(first MATCHES "\"(raylab/.*)\"")
      list(REMOVE_ITEM headers "${folder}/${CMAKE_MATCH_1}")
    endif()
  endforeach()

  set(files "")
  foreach(header IN LISTS headers)
    cmake_path(RELATIVE_PATH header BASE_DIRECTORY "${folder}" OUTPUT_VARIABLE name)
    set(file "${CMAKE_CURRENT_BINARY_DIR}/headers_alone/${name}.cpp")
    file(CONFIGURE OUTPUT "${file}" CONTENT "#include \"${name}\"\n")
    list(APPEND files "${file}")
  endforeach()
  add_library(headers_alone OBJECT EXCLUDE_FROM_ALL ${files})
  target_compile_options(headers_alone PRIVATE -Wno-psabi)  # vectors of four doubles are only passed to what is inlined
  target_link_libraries(headers_alone PRIVATE raylab_flags glm::glm fmt::fmt nlohmann_json::nlohmann_json)
  raylab_precompiled(headers_alone)
endfunction()
