# An exercise replaces exactly one function of the library, at link time.

# raylab_slot(<file>): a source file of the library, alone with one function, that an exercise may replace.
function(raylab_slot file)
  cmake_path(GET file STEM slot)
  add_library(slot_${slot} OBJECT "${file}")
  target_link_libraries(slot_${slot} PRIVATE raylab_flags raylab_instrumented glm::glm)
  raylab_precompiled(slot_${slot})
  raylab_probe(slot_${slot} ${slot})
  set_property(GLOBAL APPEND PROPERTY raylab_slots ${slot})
endfunction()

# raylab_link(<target> [SLOT <slot> FROM <file>]): the whole library (picture files and diagrams apart),
# with <slot> taken from <file>. Objects, not an archive: an archive would fill in for a misnamed answer.
# (<file>: objects, with raylab_probe(... <slot>) among them.)
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
  target_link_libraries(${target} PRIVATE raylab raylab_text raylab_exact)
endfunction()
