#pragma once

#include "raylab/base/error.h"
#include "raylab/base/memory_limit.h"
#include "raylab/geometry/affine.h"
#include "raylab/scene/scene.h"

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace raylab {

/// A shape as it stands in a scene file: in the coordinates of the group it belongs to.
struct GroupShape {
    std::string kind;  // "sphere"
    Object object;     // its placement, path and motion are made when groups are flattened
    AffineSteps steps;
    std::optional<Vec3d> motion;  // after the steps
    Place place;                  // of its transform
};

/// A group shown somewhere inside another.
struct Instance {
    std::size_t group;
    AffineSteps steps;
    std::optional<Vec3d> motion;
    Place place;
};

/// Shapes and instances in the order of the file.
struct Group {
    std::string name;
    std::vector<std::variant<GroupShape, Instance>> members = {};
};

/// The objects that the top group shows: depth first, members in order. Error for cycles, for more than most_objects
/// shapes and instances in all or than the limit has room for, and for transforms that overflow or cannot be undone.
std::vector<Object> flatten(const std::vector<Group>& groups, const Group& top, const MemoryLimit& limit = {});

}  // namespace raylab
