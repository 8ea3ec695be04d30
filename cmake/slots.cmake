# An exercise replaces exactly one function of the library, at link time.

# raylab_slot(<file>) declares a source file of the library that contains only one function, which an exercise may
# replace.
function(raylab_slot file)
  cmake_path(GET file STEM slot)
  add_library(slot_${slot} OBJECT "${file}")
  target_link_libraries(slot_${slot} PRIVATE raylab_flags raylab_instrumented glm::glm)
  raylab_precompiled(slot_${slot})
  raylab_probe(slot_${slot} ${slot})
  set_property(GLOBAL APPEND PROPERTY raylab_slots ${slot})
endfunction()

# raylab_link(<target> [SLOT <slot> FROM <file>]) links the whole library (except picture files and diagrams), with <slot>
# taken from <file>. It links objects and not an archive, because an archive would supply the reference for a misnamed
# answer. <file> must be objects that include raylab_probe(... <slot>).
function(raylab_link target)
  cmake_parse_arguments(student "" "SLOT;FROM" "" ${ARGN})
  get_property(slots GLOBAL PROPERTY raylab_slots)
  foreach(slot IN LISTS slots)
    if(slot STREQUAL "${student_SLOT}")
      target_sources(${target} PRIVATE "${student_FROM}")
      set_source_files_properties("${student_FROM}" PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    else()
      target_sources(${target} PRIVATE $<TARGET_OBJECTS:slot_${slot}>)
    endif()
  endforeach()
  raylab_probe(${target} program)
  target_link_libraries(${target} PRIVATE raylab raylab_text raylab_pictures raylab_exact)
endfunction()
