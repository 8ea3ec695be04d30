#pragma once

#include "raylab/base/command_line.h"

#include <array>
#include <string>
#include <string_view>

namespace raylab::bench {

/// A peer that is not a structure of the library, and what it needs that may not be installed.
struct OtherPeer {
    std::string_view name;
    std::string_view needs = "";
};

namespace other_peer {
inline constexpr std::string_view embree = "Embree (Debian: libembree-dev)";
inline constexpr OtherPeer embree_robust{"embree_robust", embree}, embree_default{"embree_default", embree},
    embree_high{"embree_high", embree};
inline constexpr OtherPeer cgal{"cgal", "CGAL's AABB_tree (Debian: libcgal-dev)"};
inline constexpr OtherPeer bvh8_plain{"bvh8_plain"};
inline constexpr std::array all{embree_robust, embree_default, embree_high, cgal, bvh8_plain};
}  // namespace other_peer

/// The names of all peers in one line, whether or not they are installed: "embree_robust, ..., auto".
std::string peer_list();

/// The options of `raylab bench`, which its program shares with the command that builds and runs it.
const CommandLine& command_line();

}  // namespace raylab::bench
