#include "raylab/geometry/bounds/reaches_box.h"

#include "catch.h"
#include "geometry/verdict.h"

#include <cmath>

using namespace raylab;
using namespace raylab::adversarial;

namespace {

// Grown as every caller has to grow it: by 2^-46 of the largest coordinate, here at most 8.
BoxOfDoubles grown(const Vec3d& center, const Vec3d& half) { return {center, half + Vec3d(0x1p-43)}; }

}  // namespace

TEST_CASE("a triangle reaches into every box that one of its points is in, if only in a corner") {
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        // Sixteenths of multiples of 16: the point is exact.
        const auto corner = [&] { return convert<double>(draw.on_lattice(-4, 4)) * 16.0; };
        const Vec3d a = corner(), b = corner(), c = corner();
        const int u = draw.integer(0, 16), v = draw.integer(0, 16 - u);
        const Vec3d point =
            (a * static_cast<double>(16 - u - v) + b * static_cast<double>(u) + c * static_cast<double>(v)) * 0x1p-8;
        const Vec3d half = convert<double>(draw.on_lattice(0, 4)) * 0x1p-3;
        Vec3d center = point;  // the point is at a corner of the box, at an edge, on a face or inside
        for (int axis = 0; axis < 3; ++axis) center[axis] += half[axis] * draw.integer(-1, 1);
        const Triangle triangle{convert<float>(a * 0x1p-4), convert<float>(b * 0x1p-4), convert<float>(c * 0x1p-4)};
        if (reaches(triangle, grown(center, half))) return std::nullopt;
        return words(triangle.a) + words(triangle.b) + words(triangle.c);
    };
    CHECK(faults(100'000, judge) == "");
}

TEST_CASE("a triangle does not reach into a box that its own box overlaps and its plane or an edge passes") {
    const Triangle triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 4}};
    CHECK_FALSE(reaches(triangle, grown({3, 3, 1}, Vec3d(0.5))));  // beyond the slanting edge
    CHECK_FALSE(reaches(triangle, grown({1, 3, 1}, Vec3d(0.5))));  // below the plane
    CHECK(reaches(triangle, grown({1, 1, 1}, Vec3d(0.5))));
}

TEST_CASE("a sphere's surface does not reach into a box inside the ball, or outside it") {
    const Sphere sphere{{1, 2, 3}, 2};
    CHECK_FALSE(reaches(sphere, grown({1, 2, 3}, Vec3d(1))));
    CHECK(reaches(sphere, grown({1, 2, 3}, Vec3d(1.2))));
    CHECK_FALSE(reaches(sphere, grown({2.9, 3.9, 4.9}, Vec3d(0.5))));  // in its box's corner
    CHECK(reaches(sphere, grown({3.5, 2, 3}, Vec3d(0.5))));            // touches it
}
