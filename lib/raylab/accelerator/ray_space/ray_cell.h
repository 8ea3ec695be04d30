#pragma once

#include "raylab/geometry/box.h"
#include "raylab/geometry/ray.h"

#include <array>
#include <cstddef>
#include <optional>

namespace raylab {

/// A ray as a point of ray space: where it begins, and through which point of which face of the unit cube about its origin
/// it goes. (Arvo and Kirk, Fast Ray Tracing by Ray Classification, SIGGRAPH 1987.)
struct RayPoint {
    int face;  // 0 to 5: +x, -x, +y, -y, +z, -z
    std::array<double, 5> at;  // the origin; the direction's two other coordinates over its largest one, -1 to 1
    double along;              // the size of its largest coordinate: t times this is the depth along the face's axis
};

/// Absent for a ray without such a point (a direction that is not finite), or one that begins before its origin.
std::optional<RayPoint> ray_point(const Ray& ray);

/// Rays of one face from a box of origins in a range of directions: five intervals, closed.
struct RayCell {
    int face;
    std::array<double, 5> low, high;

    bool contains(const RayPoint& point) const;
    RayCell below(std::size_t axis, double cut) const;
    RayCell above(std::size_t axis, double cut) const;

    /// A lower bound of the depth along the face's axis at which one of the rays meets the box; absent: surely none does.
    std::optional<double> depth_of(const Box& box) const;
};

}  // namespace raylab
