#include "raylab/radiosity/form_factor/polygon_points.h"

#include "raylab/radiosity/form_factor/convex_polygon.h"
#include "raylab/radiosity/form_factor/gauss_legendre.h"

#include <algorithm>

namespace raylab {

std::vector<PolygonPoint> gauss_points(std::span<const Vec3d> polygon, int per_side) {
    const Vec3d normal = polygon_normal(polygon);
    const auto rule = gauss_legendre(per_side);
    std::vector<PolygonPoint> points;
    for (std::size_t i = 1; i + 1 < polygon.size(); i += 2) {
        // A quadrangle a b c d is the bilinear image of the unit square; a triangle is one whose last two vertices are
        // equal.
        const Vec3d a = polygon[0], b = polygon[i], c = polygon[i + 1],
                    d = polygon[std::min(i + 2, polygon.size() - 1)];
        for (const auto [v, weight_v] : rule)
            for (const auto [u, weight_u] : rule) {
                const Vec3d position = (1 - v) * ((1 - u) * a + u * b) + v * ((1 - u) * d + u * c);
                const Vec3d along_u = (1 - v) * (b - a) + v * (c - d), along_v = (1 - u) * (d - a) + u * (c - b);
                points.push_back({position, weight_u * weight_v * dot(normal, cross(along_u, along_v))});
            }
    }
    return points;
}

}  // namespace raylab
