#include "catch.h"

#include "raylab/geometry/oracle.h"

#include <cmath>
#include <limits>
#include <vector>

using namespace raylab;
using oracle::Meeting;

// Every expected number here is worked out by hand from the definitions in shapes.h.

namespace {

oracle::Answer meet(Vec3d origin, Vec3d direction, const Shape& shape) {
    return oracle::meet(RayOf<double>{origin, direction, {0, std::numeric_limits<double>::infinity()}}, shape);
}

void check_hit(const oracle::Answer& answer, Meeting meeting, double t) {
    CHECK(answer.meeting == meeting);
    REQUIRE(answer.hit());
    CHECK(is_eq(answer.t->compare(t)));
}

void check_none(const oracle::Answer& answer, Meeting meeting) {
    CHECK(answer.meeting == meeting);
    CHECK_FALSE(answer.hit());
}

const Vec3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
const float above_four = std::nextafter(4.0f, 5.0f), above_five = std::nextafter(5.0f, 6.0f);

}  // namespace

TEST_CASE("oracle: an ellipsoid is hit where its equation says") {
    const Ellipsoid ellipsoid{{1, 2, 3}, {5, 7, 10}};
    check_hit(meet({4, 2, -17}, z, ellipsoid), Meeting::interior, 12);  // (3/5)^2 + (8/10)^2 = 1
    check_hit(meet({1, 2, 3}, -z, ellipsoid), Meeting::interior, 10);
    check_hit(meet({6, 2, -17}, z, ellipsoid), Meeting::tangent, 20);
    check_none(meet({above_five + 1, 2, -17}, z, ellipsoid), Meeting::miss);
}

TEST_CASE("oracle: an ellipsoid with a zero radius is nothing") {
    check_none(meet({0, 0, -5}, z, Ellipsoid{{0, 0, 0}, {1, 1, 0}}), Meeting::miss);
}

TEST_CASE("oracle: a cylinder is hit between its ends, both included") {
    const Cylinder cylinder{{0, 0, 0}, {0, 0, 4}, 5};
    check_hit(meet({-10, 3, 1}, x, cylinder), Meeting::interior, 6);
    check_hit(meet({-10, 5, 1}, x, cylinder), Meeting::tangent, 10);
    check_hit(meet({-10, 3, 0}, x, cylinder), Meeting::boundary, 6);
    check_hit(meet({-10, 3, 4}, x, cylinder), Meeting::boundary, 6);
    check_hit(meet({-10, 5, 4}, x, cylinder), Meeting::boundary, 10);
    check_none(meet({-10, 3, above_four}, x, cylinder), Meeting::miss);
    check_none(meet({-10, above_five, 1}, x, cylinder), Meeting::miss);
    check_none(meet({0, 0, -2}, z, cylinder), Meeting::miss);
}

TEST_CASE("oracle: a ray that passes over an open cylinder's rim hits it from inside") {
    check_hit(meet({0, 0, 5.5}, {2, 0, -1}, Cylinder{{0, 0, 0}, {0, 0, 4}, 5}), Meeting::interior, 2.5);
    check_hit(meet({0, 0, 5.5}, {2, 0, -1}, Cylinder{{0, 0, 0}, {0, 0, 4}, 5, Ends::capped}), Meeting::interior, 1.5);
}

TEST_CASE("oracle: caps close a cylinder, rims included") {
    const Cylinder cylinder{{0, 0, 0}, {0, 0, 4}, 5, Ends::capped};
    check_hit(meet({3, 0, -2}, z, cylinder), Meeting::interior, 2);
    check_hit(meet({3, 0, 1}, z, cylinder), Meeting::interior, 3);
    check_hit(meet({0, 0, 9}, -z, cylinder), Meeting::interior, 5);
    check_none(meet({above_five, 0, -2}, z, cylinder), Meeting::miss);
    check_hit(meet({2, 4, -4}, {1, 0, 4}, cylinder), Meeting::boundary, 1);  // to the rim's (3, 4, 0)
}

TEST_CASE("oracle: along a generator the side is missed, the caps are hit on their rims") {
    check_none(meet({3, 4, -2}, z, Cylinder{{0, 0, 0}, {0, 0, 4}, 5}), Meeting::within);
    check_hit(meet({3, 4, -2}, z, Cylinder{{0, 0, 0}, {0, 0, 4}, 5, Ends::capped}), Meeting::boundary, 2);
}

TEST_CASE("oracle: in the plane of a cap the side's rim is hit") {
    check_hit(meet({-10, 3, 4}, x, Cylinder{{0, 0, 0}, {0, 0, 4}, 5, Ends::capped}), Meeting::boundary, 6);
    check_none(meet({-10, 6, 4}, x, Cylinder{{0, 0, 0}, {0, 0, 4}, 5, Ends::capped}), Meeting::within);
}

TEST_CASE("oracle: a slanted cylinder is met in its own frame") {
    // Axis (2, 2, 1), and (1, -2, 2), (2, -1, -2) across it: all of length 3, at right angles.
    const Cylinder cylinder{{1, 1, 1}, {3, 3, 2}, 3};
    const Vec3d middle(2, 2, 1.5), across(1, -2, 2), aside(2, -1, -2), axis(2, 2, 1);
    check_hit(meet(middle - 5.0 * across, across, cylinder), Meeting::interior, 4);
    check_hit(meet(middle - 5.0 * across + aside, across, cylinder), Meeting::tangent, 5);
    check_hit(meet(middle - 5.0 * across + 0.5 * axis, across, cylinder), Meeting::boundary, 4);
    check_none(meet(middle - 5.0 * across + 0.75 * axis, across, cylinder), Meeting::miss);
}

TEST_CASE("oracle: a cylinder of radius zero is its axis") {
    const Cylinder axis{{0, 0, 0}, {0, 0, 4}, 0, Ends::capped};
    check_hit(meet({-3, 0, 2}, x, axis), Meeting::tangent, 3);
    check_hit(meet({-3, 0, 4}, x, axis), Meeting::boundary, 3);
    check_none(meet({-3, 1, 2}, x, axis), Meeting::miss);
    check_none(meet({0, 0, -2}, z, axis), Meeting::within);
}

TEST_CASE("oracle: a cone is hit on its one nappe, apex and rim included") {
    const Cone cone{{0, 0, 0}, {0, 0, 4}, 4, 0};  // rho = 4 - z
    check_hit(meet({-10, 0, 1}, x, cone), Meeting::interior, 7);
    check_hit(meet({-10, 0, 0}, x, cone), Meeting::boundary, 6);
    check_hit(meet({-10, 0, 4}, x, cone), Meeting::boundary, 10);  // the apex
    check_hit(meet({0, 0, 9}, -z, cone), Meeting::boundary, 5);    // and from above
    check_hit(meet({-10, 3, 1}, x, cone), Meeting::tangent, 10);
    check_none(meet({-10, 0, 5}, x, cone), Meeting::miss);  // the other nappe is not there
    check_none(meet({-10, 1, 4}, x, cone), Meeting::miss);
}

TEST_CASE("oracle: a ray parallel to a generator of a cone meets it once") {
    const Vec3d down(-1, 0, 1);
    check_hit(meet({6, 0, -4}, down, Cone{{0, 0, 0}, {0, 0, 4}, 4, 0}), Meeting::interior, 7);
    check_hit(meet({6, 0, -4}, down, Cone{{0, 0, 0}, {0, 0, 4}, 4, 0, Ends::capped}), Meeting::interior, 4);
}

TEST_CASE("oracle: along a cone's generator only the base cap is hit, for an apex is no cap") {
    const Cone open{{0, 0, 0}, {0, 0, 4}, 4, 0}, capped{{0, 0, 0}, {0, 0, 4}, 4, 0, Ends::capped};
    check_none(meet({8, 0, -4}, {-1, 0, 1}, open), Meeting::within);
    check_hit(meet({8, 0, -4}, {-1, 0, 1}, capped), Meeting::boundary, 4);
    check_hit(meet({-4, 0, 8}, {1, 0, -1}, capped), Meeting::boundary, 8);
}

TEST_CASE("oracle: a truncated cone has two caps and no apex") {
    const Cone cone{{0, 0, 0}, {0, 0, 4}, 6, 2, Ends::capped};  // rho = 6 - z
    check_hit(meet({1, 0, 9}, -z, cone), Meeting::interior, 5);
    check_hit(meet({3, 0, 9}, -z, cone), Meeting::interior, 6);
    check_hit(meet({3, 0, -9}, z, cone), Meeting::interior, 9);
    check_none(meet({-10, 0, 5}, x, cone), Meeting::miss);
}

TEST_CASE("oracle: a paraboloid is hit from its vertex to its rim") {
    const Paraboloid paraboloid{{0, 0, 0}, {0, 0, 4}, 4};  // rho^2 = 4 z
    check_hit(meet({-10, 0, 1}, x, paraboloid), Meeting::interior, 8);
    check_hit(meet({-10, 0, 4}, x, paraboloid), Meeting::boundary, 6);
    check_hit(meet({0, 0, -3}, z, paraboloid), Meeting::interior, 3);  // the vertex is smooth, not a rim
    check_hit(meet({-10, 0, 0}, x, paraboloid), Meeting::tangent, 10);
    check_none(meet({-10, 0, above_four}, x, paraboloid), Meeting::miss);
    check_none(meet({5, 0, -3}, z, paraboloid), Meeting::miss);
}

TEST_CASE("oracle: a paraboloid's one cap is at the top") {
    check_hit(meet({1, 0, 10}, -z, Paraboloid{{0, 0, 0}, {0, 0, 4}, 4}), Meeting::interior, 9.75);
    check_hit(meet({1, 0, 10}, -z, Paraboloid{{0, 0, 0}, {0, 0, 4}, 4, Ends::capped}), Meeting::interior, 6);
    check_hit(meet({1, 0, -10}, z, Paraboloid{{0, 0, 0}, {0, 0, 4}, 4, Ends::capped}), Meeting::interior, 10.25);
}

TEST_CASE("oracle: a hyperboloid is narrow in the middle and wide at both ends") {
    const Hyperboloid hyperboloid{{0, 0, 0}, {0, 0, 8}, 3, 5};  // rho^2 = 9 + (z - 4)^2
    check_hit(meet({-10, 0, 4}, x, hyperboloid), Meeting::interior, 7);
    check_hit(meet({-10, 0, 0}, x, hyperboloid), Meeting::boundary, 5);
    check_hit(meet({-10, 4, 8}, x, hyperboloid), Meeting::boundary, 7);
    check_hit(meet({3, -2, 4}, y, hyperboloid), Meeting::tangent, 2);
    check_none(meet({-10, 4, 4}, x, hyperboloid), Meeting::miss);
    check_none(meet({-10, 0, -1}, x, hyperboloid), Meeting::miss);
}

TEST_CASE("oracle: a hyperboloid is ruled: along its line only caps are hit") {
    const Vec3d before_the_base(3, -10, -6), ruling(0, 1, 1);
    check_none(meet(before_the_base, ruling, Hyperboloid{{0, 0, 0}, {0, 0, 8}, 3, 5}), Meeting::within);
    check_hit(meet(before_the_base, ruling, Hyperboloid{{0, 0, 0}, {0, 0, 8}, 3, 5, Ends::capped}), Meeting::boundary,
              6);
}

TEST_CASE("oracle: a hyperboloid without a waist is a double cone") {
    const Hyperboloid cone{{0, 0, 0}, {0, 0, 8}, 0, 4};  // rho = |z - 4|
    check_hit(meet({-10, 0, 6}, x, cone), Meeting::interior, 8);
    check_hit(meet({-10, 0, 2}, x, cone), Meeting::interior, 8);
    check_hit(meet({-10, 0, 4}, x, cone), Meeting::tangent, 10);
}

TEST_CASE("oracle: negative radii and axes without length make no surface") {
    for (const Shape& shape : std::vector<Shape>{
             Cylinder{{0, 0, 0}, {0, 0, 4}, -5, Ends::capped}, Cone{{0, 0, 0}, {0, 0, 4}, -5, 5, Ends::capped},
             Cone{{0, 0, 0}, {0, 0, 4}, 5, -5, Ends::capped}, Paraboloid{{0, 0, 0}, {0, 0, 4}, -5, Ends::capped},
             Hyperboloid{{0, 0, 0}, {0, 0, 4}, -3, 5, Ends::capped},
             Hyperboloid{{0, 0, 0}, {0, 0, 4}, 3, -5, Ends::capped}, Cylinder{{0, 0, 2}, {0, 0, 2}, 5, Ends::capped},
             Ellipsoid{{0, 0, 0}, {-1, 1, 1}}, Sphere{{0, 0, 2}, -1}}) {
        check_none(meet({-10, 0, 2}, x, shape), Meeting::miss);
        check_none(meet({0, 0, -9}, z, shape), Meeting::miss);
    }
}
