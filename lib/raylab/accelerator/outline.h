#pragma once

#include "raylab/geometry/box.h"
#include "raylab/geometry/shapes.h"

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

// What a structure looks like, in words that diagrams understand: whatever it is made of.

namespace raylab {

/// A box that may stand in any direction: center + x axes[0] + y axes[1] + z axes[2] with -1 <= x, y, z <= 1.
struct OrientedBox {
    Vec3f center{0};
    std::array<Vec3f, 3> half_axes{};
};

/// Where a cell or a node is.
using Bound = std::variant<Box, Sphere, OrientedBox>;

/// A structure as nested bounds: the first node is the root.
struct Outline {
    struct Node {
        Bound bound;
        std::vector<std::uint32_t> children = {};   // indices of nodes
        std::vector<std::uint32_t> primitives = {};  // of a leaf or cell: which objects' primitives, as places in scene order
        std::string label = {};                      // what else is to be said: "x = 1.5"
    };
    std::vector<Node> nodes;
};

/// A cell or node that a ray comes to.
struct Visit {
    Bound bound;
    enum class Kind { inner, leaf, empty } kind;  // whether primitives are tested there
    std::size_t tests = 0;                        // how many
};

}  // namespace raylab
