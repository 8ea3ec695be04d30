#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/shapes.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

namespace raylab {

/// An axis-aligned box, closed. Where it bounds a shape it is rounded outward: the exact shape lies inside.
struct Box {
    Vec3f min{std::numeric_limits<float>::infinity()};  // empty until something is united with it
    Vec3f max{-std::numeric_limits<float>::infinity()};

    bool is_empty() const { return min.x > max.x; }
    Vec3d center() const;  // each half taken apart: no overflow
};

/// The smallest box about both. (Coordinate by coordinate: glm's min and max of vectors call through pointers.)
inline Box unite(const Box& a, const Box& b) {
    return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
            {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}

/// The surface area, in square metres; 0 for an empty box.
inline double surface_area(const Box& box) {
    if (box.is_empty()) return 0;
    const double x = double{box.max.x} - box.min.x, y = double{box.max.y} - box.min.y,
                 z = double{box.max.z} - box.min.z;
    return 2 * (x * y + y * z + z * x);
}

Box bounds(const Triangle& triangle);

/// The box about a transformed shape; absent: unbounded (a plane). An end beyond the floats is infinite.
std::optional<Box> bounds(const Shape& shape, const Affine& placement = {});

/// The box about one transformed triangle.
Box bounds(const Triangle& triangle, const Affine& placement);

/// The same about what moves, where it stands at a time.
std::optional<Box> bounds(const Shape& shape, const Affine& placement, const Motion& motion, float time);
Box bounds(const Triangle& triangle, const Affine& placement, const Motion& motion, float time);

/// The boxes about the corners of a polygon, as they lie in its exact plane.
std::vector<Box> corner_bounds(const Polygon& polygon, const Affine& placement);

}  // namespace raylab
