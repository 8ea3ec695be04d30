# The flags with which all of raylab's own code is compiled.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
# NDEBUG is not defined: mistakes of the program are assertions, and tests run the code that is shipped.
set(RAYLAB_OPTIMIZE "-O2" CACHE STRING "The level of optimisation; the sanitizer presets set a lower one")
set(CMAKE_CXX_FLAGS_RELEASE "${RAYLAB_OPTIMIZE}")
# A lower level is used for code that takes long to compile and whose speed does not matter: readers and writers of text,
# pages, graders, tests from outside.
set(RAYLAB_OPTIMIZE_TEXT "-O1" CACHE STRING "The level for code that reads and writes text; -O0 in the sanitizer presets")

# A build folder keeps its first launcher: otherwise everything would be compiled again when ccache is installed later.
find_program(CCACHE ccache)
if(CCACHE)
  # Without these permissions ccache keeps no object that uses a precompiled header.
  set(found_launcher "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros "${CCACHE}")
endif()
set(RAYLAB_LAUNCHER "${found_launcher}" CACHE STRING "The program that starts the compiler: ccache, or none")
set(CMAKE_CXX_COMPILER_LAUNCHER "${RAYLAB_LAUNCHER}")

option(RAYLAB_FUZZ "Build tests/fuzz: clang's libFuzzer on every reader" OFF)
set(RAYLAB_SANITIZE "" CACHE STRING "Sanitizers, comma-separated: address,undefined or thread")

# Code that makes geometric decisions reports at run time if it lacks the last two of these flags (probes.cmake), and
# tests/layers checks the flags of every file.
add_library(raylab_flags INTERFACE)
target_include_directories(raylab_flags INTERFACE "${PROJECT_SOURCE_DIR}/lib")
target_compile_options(raylab_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror=float-conversion
  -Wno-missing-field-initializers  # options are aggregates: a member that is not named keeps its default
  # GCC's default contracts a*b - c*d to a fused operation, which is no longer antisymmetric:
  # neighbouring triangles then disagree about the edge they share.
  -ffp-contract=off
  # GCC 12 at -O2 compiles { out[0] = float(in[0]); out[1] = float(in[1]); } on doubles to a plain copy: its SLP
  # vectoriser loses the rounding to float (tests/number/scalar.cpp), so that numbers taken for floats would be doubles.
  $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)

# Instrumentation is a library of its own, because CGAL's objects are built without it (with it a file takes 34 s and
# 1.1 GB).
add_library(raylab_instrumented INTERFACE)
if(RAYLAB_SANITIZE)
  target_compile_options(raylab_instrumented INTERFACE
    -fsanitize=${RAYLAB_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all -g1)
  add_link_options(-fsanitize=${RAYLAB_SANITIZE})
  # Of Debian's two linkers gold takes half as long for the instrumented library, which is linked into every program.
  find_program(GOLD ld.gold)
  if(GOLD)
    add_link_options(-fuse-ld=gold)
  endif()
endif()

# Only readers are compiled with a fuzzer's counters, which would cost every other function a tenth of its time.
add_library(raylab_text_flags INTERFACE)
target_compile_options(raylab_text_flags INTERFACE ${RAYLAB_OPTIMIZE_TEXT} $<$<BOOL:${RAYLAB_FUZZ}>:-fsanitize=fuzzer-no-link>)

# The headers of the standard library and GLM are compiled once instead of six hundred times: a clean build takes little
# more than half the time. Students' files are compiled without precompiled headers.
option(RAYLAB_PRECOMPILE "Precompile the headers of the standard library" ON)
set(RAYLAB_PRECOMPILED <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <optional> <span>
  <string> <variant> <vector> <fmt/format.h> <glm/glm.hpp>)

# raylab_precompile(<name> [FLAGS <library>] <header>...) precompiles these headers for
# raylab_precompiled(<target> [FROM <name>]). FLAGS is for targets with other flags: headers that are precompiled without
# optimisation, or with a fuzzer's counters, cannot be used with other flags.
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
    target_link_libraries(${target} PRIVATE fmt::fmt)  # precompiled headers need equal definitions
  endif()
endfunction()
