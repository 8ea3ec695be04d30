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

/// A shape as it is written in a scene file, in the coordinates of the group that it belongs to.
struct GroupShape {
    std::string kind;  // "sphere"
    Object object;     // its placement, path and motion are set when groups are flattened
    AffineSteps steps;
    std::optional<Vec3d> motion;     // applied after the steps
    std::optional<AffineSteps> end;  // what the steps are when the shutter closes; absent: the same
    Place place;                     // where the file defines its transform
};

/// An instance of a group inside another group.
struct Instance {
    std::size_t group;
    AffineSteps steps;
    std::optional<Vec3d> motion;
    std::optional<AffineSteps> end;
    Place place;
};

/// Shapes and instances in the order of the file.
struct Group {
    std::string name;
    std::vector<std::variant<GroupShape, Instance>> members = {};
};

/// The objects that the top group consists of: depth first, members in order. It throws an Error for cycles, for more
/// shapes and instances than max_objects or than the memory limit permits, and for transforms that overflow or are not
/// invertible, at any time while rays pass.
std::vector<Object> flatten(const std::vector<Group>& groups, const Group& top, const std::optional<Shutter>& shutter,
                            const MemoryLimit& limit = {});

}  // namespace raylab
