# The packages raylab stands on; `raylab doctor` and the script's list name the Debian packages.
find_package(Threads REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(tomlplusplus REQUIRED)  # its headers alone: scene/toml/parse.cpp says why
find_package(PkgConfig REQUIRED)
pkg_check_modules(GRAPHVIZ REQUIRED IMPORTED_TARGET libgvc libcgraph)

# CGAL adds -frounding-math to whatever links it and sets a build type: only raylab_exact links it.
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
find_package(CGAL REQUIRED QUIET)

find_package(PNG REQUIRED)

# By pkg-config: Debian's CMake targets of OpenImageIO name folders and files of packages it does not depend on.
pkg_check_modules(OPENIMAGEIO REQUIRED IMPORTED_TARGET OpenImageIO)

# SIMD whose instruction set is picked at run time (accelerator/wide, accelerator/shape_rows).
find_package(hwy REQUIRED CONFIG)
