#include "raylab/geometry/bounds/bounding_sphere.h"

#include "raylab/number/next_float.h"

#include <cmath>
#include <limits>

namespace raylab {

namespace {

constexpr int steps_among_few = 64, steps_among_all = 4;  // together within a few per cent of the smallest radius

double reach(const Vec3d& center, const Ball& ball) { return glm::length(ball.center - center) + ball.radius; }

struct Farthest {
    const Ball* ball = nullptr;
    double reach = 0;
};

Farthest farthest(const Vec3d& center, std::span<const Ball> balls) {
    Farthest found;
    for (const Ball& ball : balls)
        if (const double far = reach(center, ball); !found.ball || far > found.reach) found = {&ball, far};
    return found;
}

Vec3d middle(std::span<const Ball> balls) {
    Vec3d low(std::numeric_limits<double>::infinity()), high = -low;
    for (const Ball& ball : balls) {
        low = glm::min(low, ball.center - ball.radius);
        high = glm::max(high, ball.center + ball.radius);
    }
    return (low + high) / 2.0;
}

// Moves the center some steps toward the far sides of whatever reaches farthest, each shorter than the one before, and
// keeps the best.
Vec3d improved(Vec3d center, std::span<const Ball> balls, int steps, int first_step) {
    Vec3d best = center;
    double smallest = std::numeric_limits<double>::infinity();
    for (int step = first_step; step <= first_step + steps; ++step) {
        const auto [far, radius] = farthest(center, balls);
        if (radius < smallest) {
            smallest = radius;
            best = center;
        }
        const Vec3d way = far->center - center;
        const double distance = glm::length(way);
        if (!(distance > 0)) break;
        center += way * (radius / distance / (step + 1));
    }
    return best;
}

// The length has six roundings, the sum one: each costs at most 2^-53 of what it yields.
float radius_about(const Vec3f& center, std::span<const Ball> balls) {
    const Vec3d c = convert<double>(center);
    return rounded_up(farthest(c, balls).reach * (1 + 16 * unit_roundoff<double>));
}

}  // namespace

Sphere bounding_sphere(std::span<const Ball> balls) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    if (balls.empty()) return {Vec3f(0), -infinity};
    if (!is_finite(balls)) return {Vec3f(0), infinity};

    const Hull few = extremes(balls);
    const Vec3d among_few = improved(middle(few), few, steps_among_few, 1);
    const Vec3d best = improved(among_few, balls, steps_among_all, steps_among_few);
    const Vec3f rounded = convert<float>(best);
    return {rounded, radius_about(rounded, balls)};
}

}  // namespace raylab
