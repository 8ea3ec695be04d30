#pragma once

#include "raylab/radiosity/form_factor/convex_polygon.h"
#include "raylab/radiosity/form_factor/form_factor_density.h"

namespace raylab {

/// The form factor from a polygon's centre to a disk of the other's area A around the other's centre:
/// A cos cos / (pi r^2 + A) (Wallace, Elmquist and Haines, SIGGRAPH 89). Weak spot: near polygons; between unit squares
/// at half a side's distance it is a third too large.
inline double disk_form_factor(std::span<const Vec3d> from, std::span<const Vec3d> to) {
    const Vec3d center = polygon_ball(from).center, center_to = polygon_ball(to).center;
    const double area = polygon_area(to), squared = dot(center_to - center, center_to - center);
    const double density = form_factor_density(center, polygon_normal(from), center_to, polygon_normal(to));
    return area * density * (std::numbers::pi * squared / (std::numbers::pi * squared + area));
}

}  // namespace raylab
