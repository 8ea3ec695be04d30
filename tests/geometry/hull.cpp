#include "raylab/geometry/bounds/hull.h"
#include "catch.h"
#include "geometry/every_shape.h"
#include "geometry/verdict.h"

using namespace raylab;
using namespace raylab::adversarial;

namespace {

// The extent of the hull along a direction.
double support(const Hull& hull, const Vec3d& direction) {
    double largest = -std::numeric_limits<double>::infinity();
    for (const Ball& ball : hull)
        largest = std::max(largest, dot(direction, ball.center) + ball.radius * glm::length(direction));
    return largest;
}

}  // namespace

TEST_CASE("where a ray hits a shape lies in the shape's hull, whichever way one looks") {
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        const Object target = object_of_every_kind(draw);
        const Hull balls = hull(target.shape, target.placement);
        if (balls.empty())
            return std::holds_alternative<Plane>(target.shape) ? std::nullopt : std::optional<std::string>("empty");
        const Ray ray = through(any_point(draw), transform_point(target.placement, convert<double>(any_point(draw))));
        DecisionCounts decisions;
        const auto hit = intersect(ray, target.shape, target.placement, decisions, target.sides);
        if (!hit) return std::nullopt;
        const Vec3d way = convert<double>(ray.direction) * hit->t, point = convert<double>(ray.origin) + way;
        const Vec3d direction = convert<double>(draw.in_cube(1));
        const double rounding = 1e-6 * (glm::length(way) + glm::length(point));  // t is good for a float
        if (dot(direction, point) <= support(balls, direction) + rounding) return std::nullopt;
        return fmt::format("shape {}: {}", target.shape.index(), adversarial::words(ray));
    };
    CHECK(faults(60'000, judge) == "");
}

TEST_CASE("hulls are close: a turned rod's reaches as far aside as the rod, but for a 16-gon's corners") {
    const Cylinder rod{{-3, -3, -3}, {3, 3, 3}, 0.1f};
    const Vec3d aside = glm::normalize(Vec3d{1, -1, 0});
    CHECK(support(hull(rod), aside) < 0.1021);
    CHECK(support(hull(Paraboloid{{0, 0, 0}, {0, 0, 2}, 1}), {0, 0, -1}) < 1e-6);
    Affine twice;
    for (Vec3f& column : twice.columns) column = column * 2.0f;
    CHECK(hull(Sphere{{1, 1, 1}, 1}, twice).size() == 1);
    CHECK(std::abs(support(hull(Sphere{{1, 1, 1}, 1}, twice), {1, 0, 0}) - 4) < 1e-9);
}
