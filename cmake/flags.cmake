# How everything of ours is compiled.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
# Without NDEBUG: a broken promise is an assertion, and tests run the code that ships.
set(RAYLAB_OPTIMIZE "-O2" CACHE STRING "How hard the compiler tries; the sanitizer presets ask for less")
set(CMAKE_CXX_FLAGS_RELEASE "${RAYLAB_OPTIMIZE}")
# What is long to compile and never waited for: readers and writers of text, pages, graders, tests from outside.
set(RAYLAB_OPTIMIZE_TEXT "-O1" CACHE STRING "The same for what reads and writes text; not at all in the sanitizer presets")

# A build folder keeps the launcher it began with: ccache installed later would otherwise compile everything again.
find_program(CCACHE ccache)
if(CCACHE)
  # Without this leave ccache keeps nothing that uses a precompiled header.
  set(found_launcher "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros "${CCACHE}")
endif()
set(RAYLAB_LAUNCHER "${found_launcher}" CACHE STRING "What compilers are started through: ccache, or nothing")
set(CMAKE_CXX_COMPILER_LAUNCHER "${RAYLAB_LAUNCHER}")

option(RAYLAB_FUZZ "Build tests/fuzz: clang's libFuzzer on every reader" OFF)
set(RAYLAB_SANITIZE "" CACHE STRING "Sanitizers, comma-separated: address,undefined or thread")

# What decides geometry and lacks the last two of these tells so itself (probes.cmake), and every file's are looked at in
# tests/layers.
add_library(raylab_flags INTERFACE)
target_include_directories(raylab_flags INTERFACE "${PROJECT_SOURCE_DIR}/lib")
target_compile_options(raylab_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror=float-conversion
  -Wno-missing-field-initializers  # options are aggregates: a member not named keeps its default
  # GCC's default contracts a*b - c*d to a fused operation, which is no longer antisymmetric:
  # neighbouring triangles then disagree about the edge they share.
  -ffp-contract=off
  # GCC 12 at -O2 compiles { out[0] = float(in[0]); out[1] = float(in[1]); } on doubles to a plain copy: its SLP
  # vectoriser loses the rounding to float (tests/number/scalar.cpp), and what we take for floats would be doubles.
  $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)

# Instrumentation stands apart: CGAL's objects are built without it (34 s and 1.1 GB a file with it).
add_library(raylab_instrumented INTERFACE)
if(RAYLAB_SANITIZE)
  target_compile_options(raylab_instrumented INTERFACE
    -fsanitize=${RAYLAB_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all -g1)
  add_link_options(-fsanitize=${RAYLAB_SANITIZE})
  # Of Debian's two linkers the one that takes half as long for what sanitizers make of the library, once a program.
  find_program(GOLD ld.gold)
  if(GOLD)
    add_link_options(-fuse-ld=gold)
  endif()
endif()

# Fuzzers follow readers alone: what they count costs every other function a tenth of its time.
add_library(raylab_text_flags INTERFACE)
target_compile_options(raylab_text_flags INTERFACE ${RAYLAB_OPTIMIZE_TEXT} $<$<BOOL:${RAYLAB_FUZZ}>:-fsanitize=fuzzer-no-link>)

# The standard library and GLM are read once, not six hundred times: a clean build takes little more than half the time. Students'
# files are compiled without; so is each header alone, where a missing #include shows (all_verify_interface_header_sets).
option(RAYLAB_PRECOMPILE "Precompile the headers of the standard library" ON)
set(RAYLAB_PRECOMPILED <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <optional> <span>
  <string> <variant> <vector> <fmt/format.h> <glm/glm.hpp>)

# raylab_precompile(<name> [FLAGS <library>] <header>...): these headers, for raylab_precompiled(<target> [FROM <name>]).
# (FLAGS: compiled without optimizing, or counted by a fuzzer, headers do not fit those that are not.)
function(raylab_precompile name)
  cmake_parse_arguments(headers "" "FLAGS" "" ${ARGN})
  if(RAYLAB_PRECOMPILE)
    file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp" CONTENT "")
    add_library(${name} OBJECT "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
    target_link_libraries(${name} PRIVATE raylab_flags raylab_instrumented ${headers_FLAGS} glm::glm fmt::fmt)
    target_precompile_headers(${name} PRIVATE ${headers_UNPARSED_ARGUMENTS})
  endif()
endfunction()

function(raylab_precompiled target)
  cmake_parse_arguments(headers "" "FROM" "" ${ARGN})
  if(RAYLAB_PRECOMPILE)
    if(NOT headers_FROM)
      set(headers_FROM raylab_precompiled)
    endif()
    target_precompile_headers(${target} REUSE_FROM ${headers_FROM})
    target_link_libraries(${target} PRIVATE fmt::fmt)  # its definitions: with others the precompiled headers are not used
  endif()
endfunction()
