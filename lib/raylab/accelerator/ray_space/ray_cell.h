#pragma once

#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/ray.h"

#include <array>
#include <cstddef>
#include <optional>

namespace raylab {

/// A ray as a point of ray space: its origin, and the point of a face of the unit cube about the origin through which
/// it goes. (Arvo and Kirk, Fast Ray Tracing by Ray Classification, SIGGRAPH 1987.)
struct RayPoint {
    int face;  // 0 to 5: +x, -x, +y, -y, +z, -z
    // The origin, then the direction's two other coordinates divided by the largest one, from -1 to 1.
    std::array<double, 5> at;
    // The absolute value of its largest coordinate; t times this is the depth along the face's axis.
    double along;
};

/// Absent for a ray that has no such point (its direction is not finite), or whose range begins before its origin.
std::optional<RayPoint> ray_point(const Ray& ray);

/// The rays of one face with origins in a box and directions in a range: five closed intervals.
struct RayCell {
    int face;
    std::array<double, 5> low, high;

    bool contains(const RayPoint& point) const;
    RayCell below(std::size_t axis, double cut) const;
    RayCell above(std::size_t axis, double cut) const;

    /// A lower bound of the depth along the face's axis at which any of the rays hits the box; absent where surely none
    /// does.
    std::optional<double> depth_of(const Box& box) const;
};

}  // namespace raylab
