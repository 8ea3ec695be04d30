#pragma once

#include "raylab/geometry/vector.h"

#include <cmath>
#include <numbers>

// The microscopic facets of a rough surface with normal z, as GGX distributes them (Walter, Marschner, Li and Torrance,
// "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007). alpha is 0 < alpha <= 1.

namespace raylab {

/// The area of facets with this unit normal, for each m^2 of the surface and each steradian: equation (33).
inline double ggx_facets(const Vec3d& normal, double alpha) {
    if (!(normal.z > 0)) return 0;
    const double x = normal.x / alpha, y = normal.y / alpha;
    const double length_squared = x * x + y * y + normal.z * normal.z;
    return 1 / (std::numbers::pi * alpha * alpha * length_squared * length_squared);
}

/// The share of the facets that are seen from a direction, and not hidden by others: equation (34).
inline double ggx_unmasked(const Vec3d& direction, double alpha) {
    const double squared = direction.z * direction.z;
    const double tangent_squared = (direction.x * direction.x + direction.y * direction.y) / squared;
    return squared > 0 ? 2 / (1 + std::sqrt(1 + alpha * alpha * tangent_squared)) : 0;
}

/// The unit normal of a facet of two numbers in [0, 1), chosen in proportion to the area that shows of it from a unit
/// direction above the surface (Heitz, "Sampling the GGX Distribution of Visible Normals", JCGT 7(4), 2018).
Vec3d ggx_visible_normal(const Vec3d& seen_from, double alpha, double u, double v);

/// Its density per steradian of normals.
inline double ggx_visible_normal_pdf(const Vec3d& seen_from, double alpha, const Vec3d& normal) {
    const double cosine = dot(seen_from, normal);
    if (!(cosine > 0) || !(seen_from.z > 0)) return 0;
    return ggx_unmasked(seen_from, alpha) * cosine * ggx_facets(normal, alpha) / seen_from.z;
}

}  // namespace raylab
