#include "raylab/geometry/bounds/slabs.h"

#include "raylab/number/next_float.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

using Axes = std::array<Vec3d, 3>;

constexpr Axes world_axes{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};

struct Extent {
    double low = unbounded, high = -unbounded;

    void add(const Vec3d& axis, const Ball& ball) {
        const double along = dot(axis, ball.center);
        low = std::min(low, along - ball.radius);
        high = std::max(high, along + ball.radius);
    }
    double size() const { return high - low; }
    double middle() const { return (low + high) / 2; }
};

std::array<Extent, 3> extents(const Axes& axes, std::span<const Ball> balls) {
    std::array<Extent, 3> along;
    for (const Ball& ball : balls)
        for (std::size_t i = 0; i < 3; ++i) along[i].add(axes[i], ball);
    return along;
}

double area(const Axes& axes, std::span<const Ball> balls) {
    const auto [x, y, z] = extents(axes, balls);
    return x.size() * y.size() + y.size() * z.size() + z.size() * x.size();
}

/// The best axes so far, by the area of the box that they make around the extremes.
class BestAxes {
public:
    explicit BestAxes(const Hull& extremes) : extremes_(extremes) { offer(world_axes); }

    // Each edge with the normal.
    void offer_triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
        for (const Vec3d& edge : {b - a, c - b, a - c}) offer_frame(edge, cross(b - a, c - a));
    }
    const Axes& axes() const { return best_; }

private:
    void offer_frame(const Vec3d& edge, const Vec3d& normal) {
        const double long_enough = glm::length(edge), high_enough = glm::length(normal);
        if (!(long_enough > 0 && high_enough > 0)) return;
        const Vec3d x = edge / long_enough, z = normal / high_enough;
        offer({x, cross(z, x), z});
    }
    void offer(const Axes& axes) {
        const double size = area(axes, extremes_);
        if (!(size < least_)) return;
        least_ = size;
        best_ = axes;
    }

    const Hull& extremes_;
    double least_ = unbounded;
    Axes best_ = world_axes;
};

Vec3d farthest(const Hull& balls, const auto& distance) {
    return std::ranges::max_element(balls, {}, distance)->center;
}

// A large triangle among the extremes, and the tetrahedra on both its sides.
Axes best_axes(const Hull& extremes) {
    std::size_t widest = 0;
    const auto width = [&](std::size_t i) { return glm::length(extremes[i + 1].center - extremes[i].center); };
    for (std::size_t i = 2; i < extremes.size(); i += 2)
        if (width(i) > width(widest)) widest = i;
    const Vec3d a = extremes[widest].center, b = extremes[widest + 1].center;
    const auto from_line = [&](const Ball& p) { return glm::length(cross(p.center - a, b - a)); };
    const Vec3d c = farthest(extremes, from_line), normal = cross(b - a, c - a);
    BestAxes best(extremes);
    best.offer_triangle(a, b, c);
    for (const double side : {1.0, -1.0}) {
        const Vec3d d = farthest(extremes, [&](const Ball& p) { return side * dot(p.center - a, normal); });
        best.offer_triangle(a, b, d);
        best.offer_triangle(b, c, d);
        best.offer_triangle(c, a, d);
    }
    return best.axes();
}

// The differences, products and sums err by less than 4 u of the terms' sizes added up, and the axis is unit but for
// 2^-22.
double reach(const Vec3d& axis, const Vec3d& center, const Ball& ball) {
    const Vec3d from = ball.center - center;
    const double terms = std::abs(axis.x * from.x) + std::abs(axis.y * from.y) + std::abs(axis.z * from.z);
    return (std::abs(dot(axis, from)) + 8 * unit_roundoff<double> * terms + ball.radius * (1 + 0x1p-20)) *
           (1 + 4 * unit_roundoff<double>);
}

Slabs around(const Axes& axes, std::span<const Ball> balls) {
    const auto along = extents(axes, balls);
    Slabs slabs{.center = convert<float>(axes[0] * along[0].middle() + axes[1] * along[1].middle() +
                                         axes[2] * along[2].middle())};
    for (std::size_t i = 0; i < 3; ++i) {
        slabs.axes[i] = convert<float>(axes[i]);
        double largest = 0;
        for (const Ball& ball : balls)
            largest = std::max(largest, reach(convert<double>(slabs.axes[i]), convert<double>(slabs.center), ball));
        slabs.half[static_cast<int>(i)] = rounded_up(largest);
    }
    return slabs;
}

}  // namespace

Slabs bounding_slabs(std::span<const Ball> balls) {
    if (balls.empty()) return {.half = Vec3f(-std::numeric_limits<float>::infinity())};
    if (!is_finite(balls)) return {.half = Vec3f(std::numeric_limits<float>::infinity())};
    const Axes axes = best_axes(extremes(balls));
    const bool worth_it = area(axes, balls) < area(world_axes, balls);
    return around(worth_it ? axes : world_axes, balls);
}

}  // namespace raylab
