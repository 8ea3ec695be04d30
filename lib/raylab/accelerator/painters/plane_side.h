#pragma once

#include "raylab/geometry/intersect/intersect.h"
#include "raylab/number/sign.h"

// The side of a triangle's plane on which something lies, exactly: positive where the normal (b - a) x (c - a) points.

namespace raylab {

Sign side(const Triangle& plane, const Vec3f& point, DecisionCounts& decisions);

/// The side of the point where a ray crosses the plane of another triangle, inside that triangle or not. The ray is not
/// parallel to that plane.
Sign side(const Triangle& plane, const Ray& ray, const Triangle& crossed, DecisionCounts& decisions);

/// Whether the triangle's corners span a plane.
bool has_plane(const Triangle& triangle);

}  // namespace raylab
