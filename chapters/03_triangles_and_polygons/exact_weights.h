#pragma once

#include "raylab/geometry/triangle_hit.h"

#include <optional>

namespace raylab {

/// The weights of b and c where the line through the ray intersects the triangle's plane, computed in rationals and
/// rounded once to double. Absent where it is parallel to the plane.
struct Weights {
    double u, v;
};
std::optional<Weights> exact_weights(const Ray& ray, const Triangle& triangle);

}  // namespace raylab
