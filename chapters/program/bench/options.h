#pragma once

#include "raylab/base/command_line.h"

#include <array>
#include <string_view>

namespace raylab::bench {

/// The peers that are not structures of the library, whether or not they are installed here.
inline constexpr std::array<std::string_view, 4> other_peers{"embree_robust", "embree_default", "cgal", "wide_plain"};

/// What `raylab bench` takes: its program and the command that builds and runs it share it.
const CommandLine& command_line();

}  // namespace raylab::bench
