#pragma once

#include "raylab/geometry/vector.h"

#include <cmath>

namespace raylab {

/// The density per steradian at `from` of a point that has this density per m^2 of its surface: a small area is seen
/// smaller by its distance squared and by the cosine of its normal.
inline double solid_angle_pdf(double per_area, const Vec3d& from, const Vec3d& point, const Vec3d& normal) {
    const Vec3d way = point - from;
    const double squared = dot(way, way);
    return per_area * squared * std::sqrt(squared) / std::abs(dot(way, normal));  // infinite where seen edge-on
}

}  // namespace raylab
