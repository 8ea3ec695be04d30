#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/geometry/surface/surface_position.h"

#include <cmath>

// Points found beside their surface, and shapes too small for their distance.

using namespace raylab;
using adversarial::Draw;

TEST_CASE("a point at a paraboloid's vertex is a point of space, whichever side rounding puts it on") {
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        const Paraboloid paraboloid{draw.in_cube(1), draw.in_cube(1), draw.uniform(0.01, 2)};
        const Vec3d vertex = convert<double>(paraboloid.base);
        const Ray ray = adversarial::through(convert<float>(vertex + convert<double>(draw.in_cube(10))), vertex);
        const Vec3d direction = convert<double>(ray.direction);
        const double t = dot(vertex - convert<double>(ray.origin), direction) / dot(direction, direction);
        const auto [point, error, normal] = surface_position(ray, {.t = t, .primitive = {}}, Shape(paraboloid), {});
        if (std::isfinite(error) && glm::length(point - vertex) < 1e-3 && std::abs(glm::length(normal) - 1) < 1e-9)
            return std::nullopt;
        return fmt::format("at {} {} {}: {}", point.x, point.y, point.z, adversarial::words(ray));
    };
    CHECK(adversarial::faults(10'000, judge) == "");
}

TEST_CASE("a point beside a thin shape is put back by nearly the shortest way") {
    const Ellipsoid thin{{0, 0, 0}, {1, 0.1f, 1}};
    // A tenth of the thickness: with one of Newton's steps it would go a sixth of that astray, or more.
    constexpr double beside = 0.01;
    for (const double angle : {0.3, 0.6, 0.9, 1.2}) {
        const Vec3d foot{std::cos(angle), 0.1 * std::sin(angle), 0};
        const Vec3d normal = glm::normalize(Vec3d{foot.x, foot.y / 0.01, 0});
        const Ray ray{convert<float>(foot + normal * 5.0), convert<float>(-normal)};
        const Vec3d point = surface_position(ray, {.t = 5 - beside, .primitive = {}}, Shape(thin), {}).point;
        CHECK(glm::length(point - foot) < 0.1 * beside);
    }
}

TEST_CASE("a shape so small that doubles see no way from its middle has a point, its error and a normal all the same") {
    constexpr float tiny = 1e-10f, away = 0x1p24f;  // from where doubles are 4e-9 apart
    const Ray ray{{0, 0, away}, {0, 0, -1}};
    // Each has its surface that far from the middle.
    const Shape shapes[] = {Sphere{{0, 0, 0}, tiny}, Ellipsoid{{0, 0, 0}, {tiny, 2 * tiny, tiny}},
                            Cylinder{{-1, 0, 0}, {1, 0, 0}, tiny}, Hyperboloid{{-1, 0, 0}, {1, 0, 0}, tiny, 2 * tiny}};
    for (const Shape& shape : shapes) {
        const auto [point, error, normal] = surface_position(ray, {.t = away, .primitive = {}}, shape, {});
        INFO("shape " << shape.index());
        CHECK(std::abs(glm::length(point) - double{tiny}) <= error);
        CHECK_THAT(glm::length(normal), WithinRel(1.0, 1e-12));
    }
}
