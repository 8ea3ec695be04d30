#include "catch.h"

#include "raylab/geometry/oracle/oracle.h"

#include <cmath>
#include <limits>
#include <vector>

using namespace raylab;
using oracle::HitKind;

// Every expected number here is worked out by hand from the definitions in shapes.h.

namespace {

oracle::Answer intersect(Vec3d origin, Vec3d direction, const Shape& shape) {
    return oracle::intersect(RayOf<double>{origin, direction, {0, std::numeric_limits<double>::infinity()}}, shape);
}

void check_hit(const oracle::Answer& answer, HitKind hit_kind, double t) {
    CHECK(answer.hit_kind == hit_kind);
    REQUIRE(answer.hit());
    CHECK(is_eq(answer.t->compare(t)));
}

void check_none(const oracle::Answer& answer, HitKind hit_kind) {
    CHECK(answer.hit_kind == hit_kind);
    CHECK_FALSE(answer.hit());
}

const Vec3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
const float above_four = std::nextafter(4.0f, 5.0f), above_five = std::nextafter(5.0f, 6.0f);

}  // namespace

TEST_CASE("oracle: an ellipsoid is hit where its equation says") {
    const Ellipsoid ellipsoid{{1, 2, 3}, {5, 7, 10}};
    check_hit(intersect({4, 2, -17}, z, ellipsoid), HitKind::interior, 12);  // (3/5)^2 + (8/10)^2 = 1
    check_hit(intersect({1, 2, 3}, -z, ellipsoid), HitKind::interior, 10);
    check_hit(intersect({6, 2, -17}, z, ellipsoid), HitKind::tangent, 20);
    check_none(intersect({above_five + 1, 2, -17}, z, ellipsoid), HitKind::miss);
}

TEST_CASE("oracle: an ellipsoid with a zero radius is nothing") {
    check_none(intersect({0, 0, -5}, z, Ellipsoid{{0, 0, 0}, {1, 1, 0}}), HitKind::miss);
}

TEST_CASE("oracle: a cylinder is hit between its ends, both included") {
    const Cylinder cylinder{{0, 0, 0}, {0, 0, 4}, 5};
    check_hit(intersect({-10, 3, 1}, x, cylinder), HitKind::interior, 6);
    check_hit(intersect({-10, 5, 1}, x, cylinder), HitKind::tangent, 10);
    check_hit(intersect({-10, 3, 0}, x, cylinder), HitKind::boundary, 6);
    check_hit(intersect({-10, 3, 4}, x, cylinder), HitKind::boundary, 6);
    check_hit(intersect({-10, 5, 4}, x, cylinder), HitKind::boundary, 10);
    check_none(intersect({-10, 3, above_four}, x, cylinder), HitKind::miss);
    check_none(intersect({-10, above_five, 1}, x, cylinder), HitKind::miss);
    check_none(intersect({0, 0, -2}, z, cylinder), HitKind::miss);
}

TEST_CASE("oracle: a ray that passes over an open cylinder's rim hits it from inside") {
    check_hit(intersect({0, 0, 5.5}, {2, 0, -1}, Cylinder{{0, 0, 0}, {0, 0, 4}, 5}), HitKind::interior, 2.5);
    check_hit(intersect({0, 0, 5.5}, {2, 0, -1}, Cylinder{{0, 0, 0}, {0, 0, 4}, 5, Ends::capped}), HitKind::interior,
              1.5);
}

TEST_CASE("oracle: caps close a cylinder, rims included") {
    const Cylinder cylinder{{0, 0, 0}, {0, 0, 4}, 5, Ends::capped};
    check_hit(intersect({3, 0, -2}, z, cylinder), HitKind::interior, 2);
    check_hit(intersect({3, 0, 1}, z, cylinder), HitKind::interior, 3);
    check_hit(intersect({0, 0, 9}, -z, cylinder), HitKind::interior, 5);
    check_none(intersect({above_five, 0, -2}, z, cylinder), HitKind::miss);
    check_hit(intersect({2, 4, -4}, {1, 0, 4}, cylinder), HitKind::boundary, 1);  // to the rim's (3, 4, 0)
}

TEST_CASE("oracle: along a generator the side is missed, the caps are hit on their rims") {
    check_none(intersect({3, 4, -2}, z, Cylinder{{0, 0, 0}, {0, 0, 4}, 5}), HitKind::within);
    check_hit(intersect({3, 4, -2}, z, Cylinder{{0, 0, 0}, {0, 0, 4}, 5, Ends::capped}), HitKind::boundary, 2);
}

TEST_CASE("oracle: in the plane of a cap the side's rim is hit") {
    check_hit(intersect({-10, 3, 4}, x, Cylinder{{0, 0, 0}, {0, 0, 4}, 5, Ends::capped}), HitKind::boundary, 6);
    check_none(intersect({-10, 6, 4}, x, Cylinder{{0, 0, 0}, {0, 0, 4}, 5, Ends::capped}), HitKind::within);
}

TEST_CASE("oracle: a slanted cylinder is hit in its own frame") {
    // Axis (2, 2, 1), and (1, -2, 2), (2, -1, -2) across it: all of length 3, at right angles.
    const Cylinder cylinder{{1, 1, 1}, {3, 3, 2}, 3};
    const Vec3d middle(2, 2, 1.5), across(1, -2, 2), aside(2, -1, -2), axis(2, 2, 1);
    check_hit(intersect(middle - 5.0 * across, across, cylinder), HitKind::interior, 4);
    check_hit(intersect(middle - 5.0 * across + aside, across, cylinder), HitKind::tangent, 5);
    check_hit(intersect(middle - 5.0 * across + 0.5 * axis, across, cylinder), HitKind::boundary, 4);
    check_none(intersect(middle - 5.0 * across + 0.75 * axis, across, cylinder), HitKind::miss);
}

TEST_CASE("oracle: a cylinder of radius zero is its axis") {
    const Cylinder axis{{0, 0, 0}, {0, 0, 4}, 0, Ends::capped};
    check_hit(intersect({-3, 0, 2}, x, axis), HitKind::tangent, 3);
    check_hit(intersect({-3, 0, 4}, x, axis), HitKind::boundary, 3);
    check_none(intersect({-3, 1, 2}, x, axis), HitKind::miss);
    check_none(intersect({0, 0, -2}, z, axis), HitKind::within);
}

TEST_CASE("oracle: a cone is hit on its one nappe, apex and rim included") {
    const Cone cone{{0, 0, 0}, {0, 0, 4}, 4, 0};  // rho = 4 - z
    check_hit(intersect({-10, 0, 1}, x, cone), HitKind::interior, 7);
    check_hit(intersect({-10, 0, 0}, x, cone), HitKind::boundary, 6);
    check_hit(intersect({-10, 0, 4}, x, cone), HitKind::boundary, 10);  // the apex
    check_hit(intersect({0, 0, 9}, -z, cone), HitKind::boundary, 5);    // and from above
    check_hit(intersect({-10, 3, 1}, x, cone), HitKind::tangent, 10);
    check_none(intersect({-10, 0, 5}, x, cone), HitKind::miss);  // the other nappe is not there
    check_none(intersect({-10, 1, 4}, x, cone), HitKind::miss);
}

TEST_CASE("oracle: a ray parallel to a generator of a cone hits it once") {
    const Vec3d down(-1, 0, 1);
    check_hit(intersect({6, 0, -4}, down, Cone{{0, 0, 0}, {0, 0, 4}, 4, 0}), HitKind::interior, 7);
    check_hit(intersect({6, 0, -4}, down, Cone{{0, 0, 0}, {0, 0, 4}, 4, 0, Ends::capped}), HitKind::interior, 4);
}

TEST_CASE("oracle: along a cone's generator only the base cap is hit, for an apex is no cap") {
    const Cone open{{0, 0, 0}, {0, 0, 4}, 4, 0}, capped{{0, 0, 0}, {0, 0, 4}, 4, 0, Ends::capped};
    check_none(intersect({8, 0, -4}, {-1, 0, 1}, open), HitKind::within);
    check_hit(intersect({8, 0, -4}, {-1, 0, 1}, capped), HitKind::boundary, 4);
    check_hit(intersect({-4, 0, 8}, {1, 0, -1}, capped), HitKind::boundary, 8);
}

TEST_CASE("oracle: a truncated cone has two caps and no apex") {
    const Cone cone{{0, 0, 0}, {0, 0, 4}, 6, 2, Ends::capped};  // rho = 6 - z
    check_hit(intersect({1, 0, 9}, -z, cone), HitKind::interior, 5);
    check_hit(intersect({3, 0, 9}, -z, cone), HitKind::interior, 6);
    check_hit(intersect({3, 0, -9}, z, cone), HitKind::interior, 9);
    check_none(intersect({-10, 0, 5}, x, cone), HitKind::miss);
}

TEST_CASE("oracle: a paraboloid is hit from its vertex to its rim") {
    const Paraboloid paraboloid{{0, 0, 0}, {0, 0, 4}, 4};  // rho^2 = 4 z
    check_hit(intersect({-10, 0, 1}, x, paraboloid), HitKind::interior, 8);
    check_hit(intersect({-10, 0, 4}, x, paraboloid), HitKind::boundary, 6);
    check_hit(intersect({0, 0, -3}, z, paraboloid), HitKind::interior, 3);  // the vertex is smooth, not a rim
    check_hit(intersect({-10, 0, 0}, x, paraboloid), HitKind::tangent, 10);
    check_none(intersect({-10, 0, above_four}, x, paraboloid), HitKind::miss);
    check_none(intersect({5, 0, -3}, z, paraboloid), HitKind::miss);
}

TEST_CASE("oracle: a paraboloid's one cap is at the top") {
    check_hit(intersect({1, 0, 10}, -z, Paraboloid{{0, 0, 0}, {0, 0, 4}, 4}), HitKind::interior, 9.75);
    check_hit(intersect({1, 0, 10}, -z, Paraboloid{{0, 0, 0}, {0, 0, 4}, 4, Ends::capped}), HitKind::interior, 6);
    check_hit(intersect({1, 0, -10}, z, Paraboloid{{0, 0, 0}, {0, 0, 4}, 4, Ends::capped}), HitKind::interior, 10.25);
}

TEST_CASE("oracle: a hyperboloid is narrow in the middle and wide at both ends") {
    const Hyperboloid hyperboloid{{0, 0, 0}, {0, 0, 8}, 3, 5};  // rho^2 = 9 + (z - 4)^2
    check_hit(intersect({-10, 0, 4}, x, hyperboloid), HitKind::interior, 7);
    check_hit(intersect({-10, 0, 0}, x, hyperboloid), HitKind::boundary, 5);
    check_hit(intersect({-10, 4, 8}, x, hyperboloid), HitKind::boundary, 7);
    check_hit(intersect({3, -2, 4}, y, hyperboloid), HitKind::tangent, 2);
    check_none(intersect({-10, 4, 4}, x, hyperboloid), HitKind::miss);
    check_none(intersect({-10, 0, -1}, x, hyperboloid), HitKind::miss);
}

TEST_CASE("oracle: a hyperboloid is ruled: along its line only caps are hit") {
    const Vec3d before_the_base(3, -10, -6), ruling(0, 1, 1);
    check_none(intersect(before_the_base, ruling, Hyperboloid{{0, 0, 0}, {0, 0, 8}, 3, 5}), HitKind::within);
    check_hit(intersect(before_the_base, ruling, Hyperboloid{{0, 0, 0}, {0, 0, 8}, 3, 5, Ends::capped}),
              HitKind::boundary, 6);
}

TEST_CASE("oracle: a hyperboloid without a waist is a double cone") {
    const Hyperboloid cone{{0, 0, 0}, {0, 0, 8}, 0, 4};  // rho = |z - 4|
    check_hit(intersect({-10, 0, 6}, x, cone), HitKind::interior, 8);
    check_hit(intersect({-10, 0, 2}, x, cone), HitKind::interior, 8);
    check_hit(intersect({-10, 0, 4}, x, cone), HitKind::tangent, 10);
}

TEST_CASE("oracle: negative radii and axes without length make no surface") {
    for (const Shape& shape : std::vector<Shape>{
             Cylinder{{0, 0, 0}, {0, 0, 4}, -5, Ends::capped}, Cone{{0, 0, 0}, {0, 0, 4}, -5, 5, Ends::capped},
             Cone{{0, 0, 0}, {0, 0, 4}, 5, -5, Ends::capped}, Paraboloid{{0, 0, 0}, {0, 0, 4}, -5, Ends::capped},
             Hyperboloid{{0, 0, 0}, {0, 0, 4}, -3, 5, Ends::capped},
             Hyperboloid{{0, 0, 0}, {0, 0, 4}, 3, -5, Ends::capped}, Cylinder{{0, 0, 2}, {0, 0, 2}, 5, Ends::capped},
             Ellipsoid{{0, 0, 0}, {-1, 1, 1}}, Sphere{{0, 0, 2}, -1}}) {
        check_none(intersect({-10, 0, 2}, x, shape), HitKind::miss);
        check_none(intersect({0, 0, -9}, z, shape), HitKind::miss);
    }
}
