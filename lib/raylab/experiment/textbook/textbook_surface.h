#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/scene/scene.h"

#include <optional>

namespace raylab {

// The textbook knows spheres, planes and triangles where they stand, seen from both sides, and point and spot lights.
// It takes for granted that transparent spheres do not overlap.

/// The surface that a ray hits first, in doubles, seen from the side it came from.
struct TextbookSurface {
    double t;
    Vec3d position;
    Vec3d normal;  // unit, on the ray's side
    bool outside;  // whether that is the outer side
    const Object* object;
};

/// The nearest hit inside ray.range, every object asked in turn; absent: nothing.
std::optional<TextbookSurface> textbook_surface(const Scene& scene, const RayOf<double>& ray);

}  // namespace raylab
