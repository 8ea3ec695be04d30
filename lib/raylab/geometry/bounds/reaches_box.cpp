#include "raylab/geometry/bounds/reaches_box.h"

#include "raylab/number/scalar.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab {

namespace {

// Whatever the axis, disjoint projections prove that nothing is shared; so the axis itself may be rounded, or zero.
bool separates(const Vec3d& axis, const std::array<Vec3d, 3>& corners, const Vec3d& half) {
    const double a = dot(axis, corners[0]), b = dot(axis, corners[1]), c = dot(axis, corners[2]);
    const double reach = half.x * std::abs(axis.x) + half.y * std::abs(axis.y) + half.z * std::abs(axis.z);
    return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
}

}  // namespace

bool reaches(const Triangle& triangle, const BoxOfDoubles& box) {
    const std::array corners{convert<double>(triangle.a) - box.center, convert<double>(triangle.b) - box.center,
                             convert<double>(triangle.c) - box.center};
    const std::array edges{corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]};
    for (int axis = 0; axis < 3; ++axis) {
        Vec3d along(0);
        along[axis] = 1;
        if (separates(along, corners, box.half)) return false;
    }
    if (separates(cross(edges[0], edges[1]), corners, box.half)) return false;
    for (const Vec3d& edge : edges) {
        if (separates({0, -edge.z, edge.y}, corners, box.half)) return false;
        if (separates({edge.z, 0, -edge.x}, corners, box.half)) return false;
        if (separates({-edge.y, edge.x, 0}, corners, box.half)) return false;
    }
    return true;
}

bool reaches(const Sphere& sphere, const BoxOfDoubles& box) {
    constexpr double rounded = 16 * unit_roundoff<double>;  // of a sum of three squares, and to spare
    double nearest = 0, farthest = 0;                       // squared, of the box's points from the centre
    for (int axis = 0; axis < 3; ++axis) {
        const double away = std::abs(double{sphere.center[axis]} - box.center[axis]);
        const double near = std::max(0.0, away - box.half[axis]), far = away + box.half[axis];
        nearest += near * near;
        farthest += far * far;
    }
    const double radius = sphere.radius, squared = radius * radius;
    return nearest <= squared * (1 + rounded) && farthest >= squared * (1 - rounded);
}

}  // namespace raylab
