#pragma once

#include "arguments.h"

#include "raylab/geometry/nearest_sphere_hit.h"

#include <limits>
#include <vector>

namespace raylab::grading::contour {

// A glowing panel that leans, half sunk into the floor, and a ball beside it. Nothing casts a shadow.
inline constexpr int picture_width = 240;
inline constexpr int picture_height = 160;
inline constexpr SphereOf<double> ball{{0.45, 0.75, 0.1}, 0.75};
inline constexpr Vec3d eye{1.3, 1.7, 5};
inline constexpr Vec3d panel_corner{-1.5, -0.9, 1.3}, panel_side{0.3, 0.5, -2.6}, panel_rise{-0.5, 2.6, 0.2};

/// Counter-clockwise as seen from its front, where the ball is.
inline std::vector<Vec3d> panel() {
    return {panel_corner, panel_corner + panel_side, panel_corner + panel_side + panel_rise, panel_corner + panel_rise};
}

/// What is behind a pixel; a form factor is asked for points of ball and floor.
struct Seen {
    enum class What { sky, panel, surface } what = What::sky;
    Vec3d point{0, 0, 0}, normal{0, 1, 0};
};

/// The ray's t at the panel, or infinity.
inline double panel_hit(const Vec3d& direction) {
    const Vec3d normal = cross(panel_side, panel_rise);
    const double t = dot(normal, panel_corner - eye) / dot(normal, direction);
    const Vec3d at = eye + t * direction - panel_corner;
    const double along = dot(cross(at, panel_rise), normal) / dot(normal, normal);
    const double up = dot(cross(panel_side, at), normal) / dot(normal, normal);
    const bool inside = t > 0 && along >= 0 && along <= 1 && up >= 0 && up <= 1;
    return inside ? t : std::numeric_limits<double>::infinity();
}

inline Seen seen_at(int x, int y) {
    const double scale = 1.0 / picture_height;
    const Vec3d forward = glm::normalize(Vec3d{-1.6, -1.1, -5}), right = glm::normalize(cross(forward, Vec3d{0, 1, 0}));
    const Vec3d direction = forward * 1.5 + right * ((x + 0.5 - 0.5 * picture_width) * scale) +
                            cross(right, forward) * ((0.5 * picture_height - y - 0.5) * scale);
    RayOf<double> ray{eye, direction, {0, std::numeric_limits<double>::infinity()}};
    Seen seen;
    if (direction.y < 0) {
        ray.range.max = -eye.y / direction.y;
        seen = {Seen::What::surface, eye + ray.range.max * direction, {0, 1, 0}};
    }
    if (const double t = panel_hit(direction); t < ray.range.max) {
        ray.range.max = t;
        seen = {Seen::What::panel};
    }
    if (const auto t = nearest_sphere_hit(ray, ball)) {
        const Vec3d point = eye + *t * direction;
        seen = {Seen::What::surface, point, glm::normalize(point - ball.center)};
    }
    return seen;
}

}  // namespace raylab::grading::contour
