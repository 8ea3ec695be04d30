#pragma once

#include "raylab/geometry/perpendicular.h"

namespace raylab {

/// Three unit vectors at right angles, right-handed.
struct LocalFrame {
    Vec3d x, y, z;

    Vec3d to_world(const Vec3d& local) const { return local.x * x + local.y * y + local.z * z; }
    Vec3d to_local(const Vec3d& world) const { return {dot(world, x), dot(world, y), dot(world, z)}; }
};

/// Some frame with this z, a unit vector.
inline LocalFrame frame_around(const Vec3d& z) {
    const Vec3d x = perpendicular_to(z);
    return {x, cross(z, x), z};
}

}  // namespace raylab
