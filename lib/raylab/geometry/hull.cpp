#include "raylab/geometry/hull.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

Hull corners(const Box& box) {
    Hull hull;
    for (int corner = 0; corner < 8; ++corner) {
        const auto at = [&](int axis) { return double{(corner >> axis & 1) != 0 ? box.max[axis] : box.min[axis]}; };
        hull.push_back({{at(0), at(1), at(2)}, 0});
    }
    return hull;
}

// Its exact place lies in a box rounded outward.
Ball placed(const Vec3f& vertex, const Affine& placement) {
    if (placement.is_identity()) return {convert<double>(vertex), 0};
    const Box box = bounds(Triangle{vertex, vertex, vertex}, placement);
    const Vec3d half = convert<double>(box.max) * 0.5 - convert<double>(box.min) * 0.5;
    return {box.center(), half.x + half.y + half.z};
}

}  // namespace

Hull hull(const Triangle& t, const Affine& placement) {
    return {placed(t.a, placement), placed(t.b, placement), placed(t.c, placement)};
}

Hull hull(const Shape& shape, const Affine& placement) {
    if (const auto* triangle = std::get_if<Triangle>(&shape)) return hull(*triangle, placement);
    if (const auto* sphere = std::get_if<Sphere>(&shape); sphere && placement.is_identity())
        return {{convert<double>(sphere->center), sphere->radius}};
    const auto box = bounds(shape, placement);
    return box ? corners(*box) : Hull{};
}

bool is_finite(std::span<const Ball> hull) {
    return std::ranges::all_of(hull, [](const Ball& ball) {
        const Vec3d& c = ball.center;
        return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z) && std::isfinite(ball.radius);
    });
}

}  // namespace raylab
