#pragma once

#include "raylab/geometry/nearest_sphere_hit.h"

#include <array>
#include <limits>

namespace raylab::grading::shadow {

// Four balls on a floor, a light among them, another ball above the light.
inline constexpr int picture_width = 240;
inline constexpr int picture_height = 160;
inline constexpr std::array<SphereOf<double>, 4> balls{
    {{{-1.3, 0.5, 0}, 0.5}, {{0.2, 0.35, 0.9}, 0.35}, {{1.3, 0.7, -0.4}, 0.7}, {{-0.2, 3.0, 0.1}, 0.45}}};
inline constexpr Vec3d light{-0.2, 2.2, 0.1}, eye{0, 2.6, 6.5};

struct Seen {
    bool hit = false;
    Vec3d point{0, 0, 0}, normal{0, 1, 0};
    Vec3d color{0, 0, 0};
};

inline Seen seen_at(int x, int y) {
    const double scale = 1.5 / picture_height;
    const Vec3d forward = glm::normalize(Vec3d{0, -1.4, -6.5}), right{1, 0, 0}, up = cross(right, forward);
    const Vec3d direction = forward * 2.2 + right * ((x + 0.5 - 0.5 * picture_width) * scale) +
                            up * ((0.5 * picture_height - y - 0.5) * scale);
    RayOf<double> ray{eye, direction, {0, std::numeric_limits<double>::infinity()}};
    Seen seen;
    if (direction.y < 0) {
        ray.range.max = -eye.y / direction.y;
        seen = {true, eye + ray.range.max * direction, {0, 1, 0}, {0.75, 0.7, 0.6}};
    }
    for (const auto& ball : balls)
        if (const auto t = nearest_sphere_hit(ray, ball)) {
            ray.range.max = *t;
            const Vec3d point = eye + *t * direction;
            seen = {true, point, glm::normalize(point - ball.center), {0.25, 0.5, 0.7}};
        }
    return seen;
}

}  // namespace raylab::grading::shadow
