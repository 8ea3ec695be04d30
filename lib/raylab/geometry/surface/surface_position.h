#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/ray.h"
#include "raylab/geometry/shapes.h"

// The surface position of a hit: the point put back onto the surface. The error of the point origin + t direction is
// that of t times the length of the direction: far from the camera that is much. A point made of the surface's own
// numbers errs by their last places only, wherever the ray came from (a triangle's by its barycentric weights: pbrt,
// section 6.8).

namespace raylab {

struct SurfacePosition {
    Vec3d point;
    double error;  // a bound of its distance from the exact surface, metres
    Vec3d normal;  // unit, outward as the shape defines; for triangles and polygons by the right-hand rule of their
                   // vertices
};

/// The point where `ray` hits a shape (of a mesh: the triangle `hit.primitive.part`) at its place: where it has a
/// motion, at the ray's time.
SurfacePosition surface_position(const Ray& ray, const Hit& hit, const Shape& shape, const Affine& placement,
                                 const Motion* motion = nullptr);

}  // namespace raylab
