#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/shapes.h"

#include <limits>
#include <optional>

namespace raylab {

/// An axis-aligned box, closed. Where it bounds a shape it is rounded outward: the exact shape lies inside.
struct Box {
    Vec3f min{std::numeric_limits<float>::infinity()};  // empty until something is united with it
    Vec3f max{-std::numeric_limits<float>::infinity()};

    bool is_empty() const { return min.x > max.x; }
    Vec3d center() const;  // each half taken apart: no overflow
};

Box unite(const Box& a, const Box& b);

/// In square metres; 0 for an empty box.
double surface_area(const Box& box);

Box bounds(const Triangle& triangle);

/// Of a shape at its place; absent: unbounded (a plane). An end beyond the floats is infinite.
std::optional<Box> bounds(const Shape& shape, const Affine& placement = {});

/// Of one triangle at its place.
Box bounds(const Triangle& triangle, const Affine& placement);

}  // namespace raylab
