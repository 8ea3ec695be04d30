#include "raylab/geometry/bounding_sphere.h"

#include "raylab/number/next_float.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab {

namespace {

constexpr int steps = 32;  // within a few per cent of the smallest radius

double reach(const Vec3d& center, const Ball& ball) { return glm::length(ball.center - center) + ball.radius; }

const Ball& farthest(const Vec3d& center, std::span<const Ball> balls) {
    return *std::ranges::max_element(balls, {}, [&](const Ball& ball) { return reach(center, ball); });
}

Vec3d middle(std::span<const Ball> balls) {
    Vec3d low(std::numeric_limits<double>::infinity()), high = -low;
    for (const Ball& ball : balls) {
        low = glm::min(low, ball.center - ball.radius);
        high = glm::max(high, ball.center + ball.radius);
    }
    return (low + high) / 2.0;
}

// The length has six roundings, the sum one: each costs at most 2^-53 of what it yields.
float radius_about(const Vec3f& center, std::span<const Ball> balls) {
    const Vec3d c = convert<double>(center);
    return rounded_up(reach(c, farthest(c, balls)) * (1 + 16 * unit_roundoff<double>));
}

}  // namespace

Sphere bounding_sphere(std::span<const Ball> balls) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    if (balls.empty()) return {Vec3f(0), -infinity};
    if (!is_finite(balls)) return {Vec3f(0), infinity};

    Vec3d center = middle(balls), best = center;
    double least = std::numeric_limits<double>::infinity();
    for (int step = 1; step <= steps; ++step) {
        const Ball& far = farthest(center, balls);
        const double radius = reach(center, far);
        if (radius < least) {
            least = radius;
            best = center;
        }
        const Vec3d way = far.center - center;
        const double distance = glm::length(way);
        if (!(distance > 0)) break;
        // Toward the ball's far side: to the middle between it and where the sphere's other side is, at first.
        center += way * (radius / distance / (step + 1));
    }
    const Vec3f rounded = convert<float>(best);
    return {rounded, radius_about(rounded, balls)};
}

}  // namespace raylab
