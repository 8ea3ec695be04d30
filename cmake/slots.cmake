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

# raylab_link(<target>) links the whole library and all slots. It links objects and not an archive,
# so that nothing is left out and nothing is taken twice. `raylab check` links a program anew with a student's object in a slot's place.
function(raylab_link target)
  get_property(slots GLOBAL PROPERTY raylab_slots)
  foreach(slot IN LISTS slots)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:slot_${slot}>)
  endforeach()
  raylab_probe(${target} program)
  target_link_libraries(${target} PRIVATE raylab raylab_text raylab_pictures raylab_exact)
endfunction()
