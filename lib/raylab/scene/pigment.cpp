#include "raylab/scene/pigment.h"

#include "raylab/geometry/dominant_axis.h"

#include <cmath>

namespace raylab {

Color color_at(const Checker& checker, const Vec3d& point, const Vec3d& normal) {
    const auto [first, second] = other_axes(dominant_axis(normal));
    const double u = std::floor(point[first] / checker.size), v = std::floor(point[second] / checker.size);
    const double half = (u + v) / 2;  // this test is exact, and std::fmod would be slower
    return half == std::floor(half) ? checker.a : checker.b;
}

bool is_black(const Pigment& pigment) {
    constexpr Color black{0, 0, 0};
    if (const auto* plain = std::get_if<Color>(&pigment)) return *plain == black;
    const auto& checker = std::get<Checker>(pigment);
    return checker.a == black && checker.b == black;
}

bool depends_on_point(const Pigment& pigment) {
    const auto* checker = std::get_if<Checker>(&pigment);
    return checker && checker->a != checker->b;
}

}  // namespace raylab
