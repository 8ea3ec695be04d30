#pragma once

#include "raylab/geometry/intersect.h"
#include "raylab/number/sign.h"

// On which side of a triangle's plane something lies, exactly: positive where its normal (b - a) x (c - a) points.

namespace raylab {

Sign side(const Triangle& plane, const Vec3f& point, Decisions& decisions);

/// Of the point where a ray crosses the plane of another triangle, whether or not inside it. The two are not parallel.
Sign side(const Triangle& plane, const Ray& ray, const Triangle& crossed, Decisions& decisions);

/// Whether its corners span a plane.
bool has_plane(const Triangle& triangle);

}  // namespace raylab
