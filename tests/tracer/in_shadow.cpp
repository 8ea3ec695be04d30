#include "catch.h"

#include "raylab/geometry/nearest_sphere_hit.h"
#include "raylab/tracer/in_shadow.h"

#include <limits>
#include <vector>

using namespace raylab;

namespace {

// The nearest hit of a few spheres, in doubles.
FirstHit of(const std::vector<SphereOf<double>>& spheres) {
    return [spheres](const Vec3d& origin, const Vec3d& direction) {
        std::optional<double> nearest;
        for (const auto& sphere : spheres) {
            const auto t =
                nearest_sphere_hit({origin, direction, {0, std::numeric_limits<double>::infinity()}}, sphere);
            if (t && (!nearest || *t < *nearest)) nearest = t;
        }
        return nearest;
    };
}

const FirstHit nothing = [](const Vec3d&, const Vec3d&) -> std::optional<double> { return std::nullopt; };

constexpr Vec3d up{0, 1, 0};

}  // namespace

TEST_CASE("a point is in shadow where something is between it and the light") {
    const auto ball = of({{{0, 2, 0}, 0.5}});
    CHECK(in_shadow({0, 0, 0}, up, {0, 4, 0}, ball));
    CHECK_FALSE(in_shadow({1, 0, 0}, up, {1, 4, 0}, ball));
    CHECK_FALSE(in_shadow({0, 0, 0}, up, {0, 4, 0}, nothing));
}

TEST_CASE("what is beyond the light or behind the point casts no shadow on it") {
    CHECK_FALSE(in_shadow({0, 0, 0}, up, {0, 4, 0}, of({{{0, 6, 0}, 1}})));
    CHECK_FALSE(in_shadow({0, 0, 0}, up, {0, 4, 0}, of({{{0, -3, 0}, 1}})));
}

TEST_CASE("a light behind the surface, or in it, leaves the point in shadow") {
    CHECK(in_shadow({0, 0, 0}, up, {0, -4, 0}, nothing));
    CHECK(in_shadow({0, 0, 0}, up, {5, 0, 0}, nothing));
}

TEST_CASE("a surface that the light sits on does not hide it") {
    CHECK_FALSE(in_shadow({0, 0, 0}, up, {0, 4, 0}, of({{{0, 5, 0}, 1}})));
}

TEST_CASE("what is hit a rounding before the light does not hide it") {
    const auto hit_at = [](double t) -> FirstHit { return [t](const Vec3d&, const Vec3d&) { return t; }; };
    CHECK_FALSE(in_shadow({0, 0, 0}, up, {0, 4, 0}, hit_at(1 - 0x1p-50)));
    CHECK(in_shadow({0, 0, 0}, up, {0, 4, 0}, hit_at(0.999)));
}

TEST_CASE("the way to a light begins over the surface by a share of the largest number that it is made of") {
    Vec3d begun;
    const FirstHit tells = [&](const Vec3d& origin, const Vec3d&) -> std::optional<double> {
        begun = origin;
        return std::nullopt;
    };
    for (const auto& [point, light] :
         {std::pair{Vec3d{1, 2, 3}, Vec3d{5, 1e9, 7}}, {Vec3d{1, 2, -1e9}, Vec3d{5, 100, 7}}}) {
        CHECK_FALSE(in_shadow(point, up, light, tells));
        CHECK(begun.y - point.y > 1e-2);
        CHECK(begun.y - point.y < 1);
    }
}

TEST_CASE("a sphere does not shade itself where it faces the light, at any scale and place") {
    for (const double scale : {1e-3, 1.0, 1e3})
        for (const double away : {0.0, 1e3, 1e5}) {
            const SphereOf<double> ball{Vec3d{1, 2, 3} * away, scale};
            for (int i = 0; i < 1000; ++i) {
                const Vec3d normal =
                    glm::normalize(Vec3d{std::sin(i * 1.7), std::sin(i * 2.3 + 1), std::sin(i * 3.1 + 2)});
                const Vec3d side = glm::normalize(cross(normal, Vec3d{0.3, -0.5, 0.8}));
                const Vec3d point = ball.center + normal * scale;
                CHECK_FALSE(in_shadow(point, normal, point + (normal * 1e-3 + side) * (5 * scale), of({ball})));
            }
        }
}
