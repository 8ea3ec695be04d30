#include "catch.h"

#include "raylab/geometry/oracle/oracle.h"
#include "raylab/sampling/sequence.h"

#include <array>
#include <cmath>
#include <limits>

using namespace raylab;
using oracle::HitKind;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

oracle::Answer intersect(Vec3d origin, Vec3d direction, const Shape& shape, const Affine& placement) {
    return oracle::intersect(RayOf<double>{origin, direction, {0, infinity}}, shape, placement);
}

const Affine shear{{Vec3f{1, 0, 0}, Vec3f{1, 1, 0}, Vec3f{0, 0, 1}}, {0, 0, 0}};  // x + y, y, z

bool same(const oracle::Answer& one, const oracle::Answer& other) {
    if (one.hit_kind != other.hit_kind || one.hit() != other.hit()) return false;
    return !one.hit() || is_eq(one.t->compare(*other.t));
}

}  // namespace

TEST_CASE("oracle: a sheared sphere is hit where the shear carries its points") {
    const Sphere sphere{{0, 0, 0}, 5};
    const auto crossing = intersect({-11, 3, 0}, {1, 0, 0}, sphere, shear);  // from (-4, 3, 0), carried to (-1, 3, 0)
    CHECK(crossing.hit_kind == HitKind::interior);
    CHECK(is_eq(crossing.t.value().compare(10.0)));
    const auto touching = intersect({-11, 5, 0}, {1, 0, 0}, sphere, shear);
    CHECK(touching.hit_kind == HitKind::tangent);
    CHECK(is_eq(touching.t.value().compare(16.0)));
    CHECK(intersect({-11, std::nextafter(5.0, 6.0), 0}, {1, 0, 0}, sphere, shear).hit_kind == HitKind::miss);
}

TEST_CASE("oracle: a mirrored and moved sphere is hit on its other side") {
    const Affine mirror{{Vec3f{-2, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}}, {10, 0, 0}};
    const auto answer = intersect({0, 0, 0}, {1, 0, 0}, Sphere{{1, 0, 0}, 0.5f}, mirror);  // from x = 1.5, carried to 7
    CHECK(is_eq(answer.t.value().compare(7.0)));
}

TEST_CASE("oracle: a scaled sphere is the ellipsoid of its radii, for every ray and to the last digit of t") {
    RandomSequence random(3, 0);
    const auto vector = [&] { return convert<float>(random.in_cube()); };
    int hits = 0, different = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3f radii = glm::abs(vector()) + 0.1f, center = vector();
        const Affine placement{{Vec3f{radii.x, 0, 0}, Vec3f{0, radii.y, 0}, Vec3f{0, 0, radii.z}}, center};
        const Vec3d origin = convert<double>(3.0f * vector());
        const Vec3d direction = convert<double>(center + radii * vector()) - origin;
        const auto ellipsoid = intersect(origin, direction, Ellipsoid{center, radii}, {});
        different += !same(ellipsoid, intersect(origin, direction, Sphere{{0, 0, 0}, 1}, placement));
        hits += ellipsoid.hit();
    }
    CHECK(different == 0);
    CHECK(hits > 100);
}

TEST_CASE("oracle: a placed triangle is the triangle of its placed vertices, where floats can hold those") {
    RandomSequence random(5, 0);
    const auto whole = [&](int size) { return cast<float>(random.whole(-size, size)); };
    const auto vector = [&](int size) { return Vec3f{whole(size), whole(size), whole(size)}; };
    std::array<int, 5> seen{};
    int different = 0;
    for (int i = 0; i < 3000; ++i) {
        const Affine placement{{vector(2), vector(2), vector(2)}, vector(3)};
        if (is_singular(placement)) continue;
        const Triangle triangle{vector(1), vector(1), vector(1)};
        const auto placed = [&](const Vec3f& p) { return transform_point(placement, convert<double>(p)); };
        const TriangleOf<double> image{placed(triangle.a), placed(triangle.b), placed(triangle.c)};
        const Vec3d origin = convert<double>(vector(3)), direction = convert<double>(vector(1));
        if (direction == Vec3d(0)) continue;
        const auto answer = intersect(origin, direction, triangle, placement);
        different += !same(answer, oracle::intersect(RayOf<double>{origin, direction, {0, infinity}}, image));
        ++seen[static_cast<std::size_t>(answer.hit_kind)];
    }
    CHECK(different == 0);
    for (const HitKind each : {HitKind::miss, HitKind::interior, HitKind::boundary, HitKind::within})
        CHECK(seen[static_cast<std::size_t>(each)] > 10);
}

TEST_CASE("oracle: nothing is rounded on the way to a placed shape") {
    const float third = 1.0f / 3.0f;
    const Affine placement{{Vec3f{third, 0, 0}, Vec3f{0, third, 0}, Vec3f{0, 0, third}}, {0, 0, 0}};
    const Sphere sphere{{0, 0, 0}, 1};
    CHECK(intersect({-1, third, 0}, {1, 0, 0}, sphere, placement).hit_kind == HitKind::tangent);
    CHECK(intersect({-1, std::nextafter(static_cast<double>(third), 1.0), 0}, {1, 0, 0}, sphere, placement).hit_kind ==
          HitKind::miss);
    CHECK(intersect({-1, std::nextafter(static_cast<double>(third), 0.0), 0}, {1, 0, 0}, sphere, placement).hit_kind ==
          HitKind::interior);
}

TEST_CASE("oracle: a capped cylinder keeps its rims under a shear") {
    const Cylinder cylinder{{0, 0, 0}, {0, 0, 4}, 5, Ends::capped};
    const auto rim = intersect({7, 4, 9}, {0, 0, -1}, cylinder, shear);  // above (3, 4)
    CHECK(rim.hit_kind == HitKind::boundary);
    CHECK(is_eq(rim.t.value().compare(5.0)));
    CHECK(intersect({6, 4, 9}, {0, 0, -1}, cylinder, shear).hit_kind == HitKind::interior);
}
