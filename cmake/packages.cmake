# The packages that raylab needs; the script `raylab` lists the Debian packages.
find_package(Threads REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(tomlplusplus REQUIRED)  # only its headers, for the reason in scene/toml/parse.cpp
find_package(PkgConfig REQUIRED)
pkg_check_modules(GRAPHVIZ REQUIRED IMPORTED_TARGET libgvc libcgraph)
pkg_check_modules(CMARK REQUIRED IMPORTED_TARGET libcmark-gfm)
find_library(CMARK_EXTENSIONS cmark-gfm-extensions REQUIRED)  # GitHub's tables

# CGAL adds -frounding-math to every target that links it and sets a build type, so only raylab_exact links it.
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
find_package(CGAL REQUIRED QUIET)

find_package(PNG REQUIRED)

# The labels of pictures.
pkg_check_modules(FREETYPE REQUIRED IMPORTED_TARGET freetype2)
find_file(RAYLAB_FONT DejaVuSans.ttf PATHS /usr/share/fonts/truetype/dejavu REQUIRED NO_DEFAULT_PATH)

# The walk through a scene that radiosity has solved is drawn by three.js.
find_file(RAYLAB_THREE three.min.js PATHS /usr/share/javascript/three/build /usr/share/javascript/three REQUIRED NO_DEFAULT_PATH)

# OpenImageIO is found by pkg-config, because Debian's CMake targets of it name folders and files of packages on which it
# does not depend.
pkg_check_modules(OPENIMAGEIO REQUIRED IMPORTED_TARGET OpenImageIO)

# Highway: SIMD code whose instruction set is chosen at run time (accelerator/bvh8, accelerator/shape_rows).
find_package(hwy REQUIRED CONFIG)

# Eigen: the direct solvers of radiosity's linear system.
find_package(Eigen3 REQUIRED NO_MODULE)

# libseccomp: the launcher of students' programs refuses system calls with it (exercises/isolation).
pkg_check_modules(SECCOMP REQUIRED IMPORTED_TARGET libseccomp)

# nettle: the hash of what was graded (exercises/grading/sha256.h). xxHash: whether a kept file is whole and is about the same scene
# (radiosity/cache/content_hash.h).
pkg_check_modules(NETTLE REQUIRED IMPORTED_TARGET nettle)
find_path(XXHASH xxhash.h REQUIRED)
