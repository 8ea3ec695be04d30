#pragma once

#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/shapes.h"

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

// The shape of a structure in the terms that diagrams understand, whatever kind of structure it is.

namespace raylab {

/// A box of any orientation: center + x axes[0] + y axes[1] + z axes[2] with -1 <= x, y, z <= 1.
struct OrientedBox {
    Vec3f center{0};
    std::array<Vec3f, 3> half_axes{};
};

/// The bounding volume of a cell or a node.
using Bound = std::variant<Box, Sphere, OrientedBox>;

/// A structure as nested bounds: the first node is the root.
struct Outline {
    struct Node {
        Bound bound;
        std::vector<std::uint32_t> children = {};  // indices of nodes
        // The primitives of a leaf or cell, as places of their objects in scene order.
        std::vector<std::uint32_t> primitives = {};
        std::string label = {};  // further text, such as "x = 1.5"
    };
    std::vector<Node> nodes;
};

/// A cell or node that a ray visits.
struct Visit {
    Bound bound;
    enum class Kind { inner, leaf, empty } kind;  // whether primitives are tested there
    std::size_t tests = 0;                        // the number of tests
};

}  // namespace raylab
