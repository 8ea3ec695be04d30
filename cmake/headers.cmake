# That every header compiles alone is checked by compiling it alone: all_verify_interface_header_sets.

# raylab_verify_once(<target>): takes those headers out of the check of <target> that another one includes first. Nothing stands
# before them there, so that compiling the other alone compiles them alone, too.
function(raylab_verify_once target)
  get_target_property(headers ${target} HEADER_SET)
  get_target_property(folder ${target} HEADER_DIRS)
  set(shown "")
  foreach(header IN LISTS headers)
    file(STRINGS "${header}" first REGEX "^ *# *include" LIMIT_COUNT 1)
    if(first MATCHES "\"(raylab/.*)\"")
      list(APPEND shown "${folder}/${CMAKE_MATCH_1}")
    endif()
  endforeach()
  list(REMOVE_ITEM headers ${shown})
  set_property(TARGET ${target} PROPERTY HEADER_SET "${headers}")
endfunction()
