# Code that makes geometric decisions must be compiled with the flags of flags.cmake; probes tell at run time whether it
# was.

# raylab_probe(<target> <part>) adds to <target> the probe, compiled with the target's flags, under the part's name.
function(raylab_probe target part)
  set(probe "${PROJECT_BINARY_DIR}/probes/${target}_${part}.cpp")
  file(CONFIGURE OUTPUT "${probe}" @ONLY CONTENT [[
// Made by cmake/probes.cmake.
#include "raylab/number/arithmetic_probe.h"

namespace raylab {
CompiledFaults faults_of_@part@();
CompiledFaults faults_of_@part@() { return compiled_faults(); }
}  // namespace raylab
]])
  target_sources(${target} PRIVATE "${probe}")
  set_source_files_properties("${probe}" PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endfunction()

# raylab_list_probes(<target> <part>...) adds to <target> the list of all parts, for number/exact_arithmetic.h.
function(raylab_list_probes target)
  set(declarations "")
  set(entries "")
  foreach(part IN LISTS ARGN)
    string(APPEND declarations "CompiledFaults faults_of_${part}();\n")
    string(APPEND entries "        {\"${part}\", &faults_of_${part}},\n")
  endforeach()
  set(list "${PROJECT_BINARY_DIR}/probes/list.cpp")
  file(CONFIGURE OUTPUT "${list}" @ONLY CONTENT [[
// Made by cmake/probes.cmake.
#include "raylab/number/exact_arithmetic.h"

namespace raylab {

@declarations@
std::span<const CompiledPart> compiled_parts() {
    static constexpr CompiledPart parts[] = {
@entries@    };
    return parts;
}

}  // namespace raylab
]])
  target_sources(${target} PRIVATE "${list}")
endfunction()
