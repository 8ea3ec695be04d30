# The program of the case FMA-SWITCH: the chapter's methods with contraction, the compilers' default, in a process of its
# own.
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-mfma RAYLAB_HAS_MFMA)  # x86 only; for other processors compilers fuse without a further flag
add_executable(fma_shots "${CMAKE_CURRENT_LIST_DIR}/fma/fma_shots.cpp")
target_include_directories(fma_shots PRIVATE "${PROJECT_SOURCE_DIR}/lib")
target_link_libraries(fma_shots PRIVATE glm::glm)
target_compile_options(fma_shots PRIVATE -ffp-contract=fast $<$<BOOL:${RAYLAB_HAS_MFMA}>:-mfma>
  $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
set_target_properties(fma_shots PROPERTIES
  RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/chapters/03_triangles_and_polygons")
add_custom_target(03_triangles_and_polygons_extra DEPENDS fma_shots)
