#pragma once

#include "raylab/base/command_line.h"

#include <array>
#include <string_view>

namespace raylab::bench {

/// The peers that are not structures of the library, whether or not they are installed on this machine.
inline constexpr std::array<std::string_view, 4> other_peers{"embree_robust", "embree_default", "cgal", "bvh8_plain"};

/// The options of `raylab bench`, which its program shares with the command that builds and runs it.
const CommandLine& command_line();

}  // namespace raylab::bench
