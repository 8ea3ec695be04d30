#pragma once

#include "arguments.h"
#include "exercise.h"

#include "raylab/geometry/nearest_sphere_hit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab::grading::local {

// Three balls, matt, painted and nearly black but shiny; a warm light from the left that falls off, and a cold one from
// the right and behind that does not.
inline constexpr int picture_width = 300, picture_height = 120;

struct Ball {
    SphereOf<double> sphere;
    Vec3d diffuse, specular;
    double shininess;
};
inline constexpr std::array<Ball, 3> balls{{{{{-1.25, 0, 0}, 0.6}, {0.8, 0.3, 0.2}, {0, 0, 0}, 1},
                                            {{{0, 0, 0}, 0.6}, {0.3, 0.6, 0.3}, {0.6, 0.6, 0.6}, 15},
                                            {{{1.25, 0, 0}, 0.6}, {0.05, 0.05, 0.08}, {0.9, 0.9, 0.9}, 60}}};
inline constexpr Vec3d eye{0, 0, 6}, warm{-2.2, 1.2, 1.6}, cold{3.5, 3, -1.2};

struct BallSeen {
    const Ball* ball = nullptr;
    Vec3d point{0, 0, 0};
};

inline BallSeen ball_at(int x, int y) {
    const double scale = 1.7 / picture_height;  // metres for each pixel, in the plane of the balls' centres
    const Vec3d target{(x + 0.5 - 0.5 * picture_width) * scale, (0.5 * picture_height - y - 0.5) * scale, 0};
    const RayOf<double> ray{eye, target - eye, {0, 100}};
    for (const Ball& ball : balls)  // none occludes another
        if (const auto t = nearest_sphere_hit(ray, ball.sphere)) return {&ball, ray.origin + *t * ray.direction};
    return {};
}

inline std::vector<Case> pixel_cases(int x, int y) {
    const auto [seen, point] = ball_at(x, y);
    const Ball& ball = seen ? *seen : balls[0];
    const Vec3d normal = seen ? glm::normalize(point - ball.sphere.center) : Vec3d{0, 0, 1};
    return {
        {"", Case::Kind::graded,
         as_input(
             {{normal, glm::normalize(eye - point), 0.06 * ball.diffuse, ball.diffuse, ball.specular, ball.shininess},
              {{warm - point, {2.4, 1.9, 1.2}, {0.2, 0.3, 0.4}}, {cold - point, {0.4, 0.5, 0.8}, {1, 0, 0}}}})}};
}

inline Pixel shade(int x, int y, std::span<const double> answer) {
    if (!ball_at(x, y).ball) return {0.02f, 0.03f, 0.06f};
    const auto channel = [&](std::size_t i) {
        return std::isfinite(answer[i]) ? cast<float>(std::clamp(answer[i], -1.0, 4.0)) : 0.0f;
    };
    return {channel(0), channel(1), channel(2)};
}

}  // namespace raylab::grading::local
