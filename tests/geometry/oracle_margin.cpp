#include "catch.h"

#include "raylab/geometry/oracle/oracle.h"

#include <cmath>
#include <limits>

using namespace raylab;
using oracle::margin;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const TriangleOf<double> right_angled{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
const SphereOf<double> unit{{0, 0, 0}, 1};

RayOf<double> down_at(double x, double y, Interval<double> range = {0, infinity}) {
    return {{x, y, 2}, {0, 0, -1}, range};
}

}  // namespace

TEST_CASE("margin: of a triangle's hit is its smallest area over the squared distance to the farthest vertex") {
    CHECK_THAT(margin(down_at(1, 1), right_angled), WithinRel(2.0 / 14, 1e-12));
    CHECK_THAT(margin(down_at(1, 0.5), right_angled), WithinRel(1.0 / (1 + 3.5 * 3.5 + 4), 1e-12));
}

TEST_CASE("margin: of a triangle's miss is its clearest reason") {
    CHECK_THAT(margin(down_at(1, -1), right_angled), WithinRel(2.0 / (1 + 25 + 4), 1e-12));
    CHECK_THAT(margin(down_at(1, 1, {0, 1}), right_angled), WithinRel(1 / std::sqrt(14.0), 1e-12));
    CHECK_THAT(margin(down_at(1, -1, {0, 1.5}), right_angled), WithinRel(0.5 / std::sqrt(30.0), 1e-12));
}

TEST_CASE("margin: is zero exactly on a boundary, and for what is coplanar or no surface") {
    CHECK(margin(down_at(2, 0), right_angled) == 0);
    CHECK(margin(down_at(2, 2), right_angled) == 0);
    CHECK(margin(down_at(1, 1, {0, 2}), right_angled) == 0);
    CHECK(margin(RayOf<double>{{1, 1, 0}, {0, 0, 1}, {0, infinity}}, right_angled) == 0);
    CHECK(margin(RayOf<double>{{-1, 1, 0}, {1, 0, 0}, {0, infinity}}, right_angled) == 0);
    CHECK(margin(down_at(1, 1), {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}) == 0);
    CHECK(margin(RayOf<double>{{-3, 1, 0}, {1, 0, 0}, {0, infinity}}, unit) == 0);
    CHECK(margin(RayOf<double>{{-1, 0, 0}, {-1, 0, 0}, {0, infinity}}, unit) == 0);
}

TEST_CASE("margin: depends neither on the scale of the scene nor on the length of the direction") {
    const double plain = margin(down_at(1, 0.5, {0, 3}), right_angled);
    for (const double scale : {0x1p-40, 0x1p+40}) {
        const TriangleOf<double> scaled{{0, 0, 0}, {4 * scale, 0, 0}, {0, 4 * scale, 0}};
        const RayOf<double> ray{{scale, 0.5 * scale, 2 * scale}, {0, 0, -8 * scale}, {0, 0.375}};
        CHECK_THAT(margin(ray, scaled), WithinRel(plain, 1e-12));
    }
}

TEST_CASE("margin: of a sphere counts its rim and both hits against the ends of the range") {
    // The ray starts 3 away and passes the center at 1/2: (1 - 1/4) / (9 + 1/4 + 1).
    const RayOf<double> ray{{-3, 0.5, 0}, {1, 0, 0}, {0, infinity}};
    CHECK_THAT(margin(ray, unit), WithinRel(0.75 / 10.25, 1e-12));
    CHECK_THAT(margin(RayOf<double>{{-3, 2, 0}, {1, 0, 0}, {0, infinity}}, unit), WithinRel(3.0 / 14, 1e-12));
    // Hits at 2 and 4; the range ends just before the second.
    const RayOf<double> through{{-3, 0, 0}, {1, 0, 0}, {0, 3.9375}};
    CHECK_THAT(margin(through, unit), WithinRel(0.0625 / std::sqrt(10.0), 1e-12));
}
