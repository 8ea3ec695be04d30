#include "raylab/radiosity/form_factor/convex_polygon.h"

#include <algorithm>
#include <limits>

namespace raylab {

Vec3d area_vector(std::span<const Vec3d> polygon) {
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 2; i < polygon.size(); ++i) sum += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return 0.5 * sum;
}

double polygon_area(std::span<const Vec3d> polygon) { return glm::length(area_vector(polygon)); }

Vec3d polygon_normal(std::span<const Vec3d> polygon) { return glm::normalize(area_vector(polygon)); }

PolygonBall polygon_ball(std::span<const Vec3d> polygon) {
    Vec3d center{0, 0, 0};
    for (const Vec3d& vertex : polygon) center += vertex / static_cast<double>(polygon.size());
    double radius = 0;
    for (const Vec3d& vertex : polygon) radius = std::max(radius, glm::length(vertex - center));
    return {center, radius};
}

double distance_to_polygon(const Vec3d& point, std::span<const Vec3d> polygon) {
    const Vec3d normal = polygon_normal(polygon);
    bool above = true;  // the point's foot on the plane lies in the polygon
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d from = polygon[i], edge = polygon[(i + 1) % polygon.size()] - from;
        above = above && dot(cross(normal, edge), point - from) >= 0;
        const double share = std::clamp(dot(point - from, edge) / dot(edge, edge), 0.0, 1.0);
        nearest = std::min(nearest, glm::length(point - from - share * edge));
    }
    return above ? std::abs(dot(normal, point - polygon[0])) : nearest;
}

PatchPlane patch_plane(std::span<const Vec3d> polygon) { return {polygon[0], polygon_normal(polygon)}; }

double rounding_height(std::span<const Vec3d> polygon) {
    double farthest = 0;
    for (const Vec3d& vertex : polygon) farthest = std::max(farthest, glm::length(vertex));
    return 1e-14 * farthest;
}

std::vector<Vec3d> clipped_to_front(std::span<const Vec3d> polygon, const PatchPlane& plane, double tolerance) {
    std::vector<Vec3d> kept;
    bool reaches_front = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d from = polygon[i], to = polygon[(i + 1) % polygon.size()];
        const double height_from = plane.height(from), height_to = plane.height(to);
        reaches_front = reaches_front || height_from > tolerance;
        if (height_from >= -tolerance) kept.push_back(from);
        const bool crosses =
            (height_from > tolerance && height_to < -tolerance) || (height_from < -tolerance && height_to > tolerance);
        if (crosses) kept.push_back(from + (to - from) * (height_from / (height_from - height_to)));
    }
    return reaches_front ? kept : std::vector<Vec3d>();
}

}  // namespace raylab
