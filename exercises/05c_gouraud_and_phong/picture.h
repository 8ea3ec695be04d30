#pragma once

#include "arguments.h"
#include "exercise.h"

#include "raylab/experiment/generate/generate.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace raylab::grading::mesh_hit {

// The same ball of 80 triangles twice, its highlight by Gouraud on the left and by Phong on the right.
inline constexpr int picture_width = 240, picture_height = 120;

/// Where parallel rays along -z hit the ball.
inline std::optional<InterpolatedHit> ball_at(double x, double y) {
    static const Mesh ball = icosphere(1);
    for (std::size_t i = 0; i < ball.faces.size(); ++i) {
        const auto [a, b, c] = in<double>(ball.triangle(i));
        const auto area = [](const Vec3d& p, const Vec3d& q, double s, double t) {
            return (q.x - p.x) * (t - p.y) - (q.y - p.y) * (s - p.x);
        };
        const double whole = area(a, b, c.x, c.y);
        if (!(whole > 0)) continue;  // it looks away
        const double u = area(c, a, x, y) / whole, v = area(a, b, x, y) / whole;
        if (u < 0 || v < 0 || u + v > 1) continue;
        return InterpolatedHit{{glm::normalize(a), glm::normalize(b), glm::normalize(c)},
                               glm::normalize(cross(b - a, c - a)),
                               u,
                               v,
                               {0, 0, 1}};
    }
    return std::nullopt;
}

inline std::optional<InterpolatedHit> hit_at(int x, int y) {
    constexpr double scale = 2.3 / picture_height;
    const double left = x < picture_width / 2 ? 0.25 * picture_width : 0.75 * picture_width;
    return ball_at((x + 0.5 - left) * scale, (0.5 * picture_height - y - 0.5) * scale);
}

inline std::vector<Case> pixel_cases(int x, int y) {
    static const Vec3d to_light = glm::normalize(Vec3d{-1, 1.2, 2});
    const auto hit = hit_at(x, y).value_or(
        InterpolatedHit{{Vec3d{0, 0, 1}, Vec3d{0, 0, 1}, Vec3d{0, 0, 1}}, {0, 0, 1}, 0.25, 0.25, {0, 0, 1}});
    return {{"", Case::Kind::graded, as_input({hit, {to_light, {0, 0, 1}, 0.08, 0.5, 0.5, 30}})}};
}

inline Pixel shade(int x, int y, std::span<const double> answer) {
    if (!hit_at(x, y)) return {0.02f, 0.03f, 0.06f};
    const double value = answer[x < picture_width / 2 ? 0 : 1];
    if (!std::isfinite(value)) return {0.8f, 0, 0.5f};
    const auto grey = cast<float>(std::clamp(value, 0.0, 2.0));
    return {grey, 0.8f * grey, 0.5f * grey};
}

}  // namespace raylab::grading::mesh_hit
