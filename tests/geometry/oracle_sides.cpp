#include "catch.h"

#include "raylab/geometry/oracle/oracle.h"

#include <limits>
#include <vector>

using namespace raylab;

namespace {

/// The t at which the ray first sees the shape; -1: nowhere. Every t here is a whole number or a half.
double first(Vec3d origin, Vec3d direction, const Shape& shape, Sides sides, const Affine& placement = {}) {
    const RayOf<double> ray{origin, direction, {0, std::numeric_limits<double>::infinity()}};
    const auto answer = oracle::intersect(ray, shape, placement, sides);
    return answer.hit() ? answer.t->nearest() : -1;
}

const Vec3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);

}  // namespace

TEST_CASE("oracle: a flat shape's front is where its normal points, by the right-hand rule of its vertices") {
    for (const Shape& up : std::vector<Shape>{Triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},
                                              Polygon{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}},
                                              Plane{{0, 0, 0}, {0, 0, 1}}, Disk{{1, 1, 0}, {0, 0, 1}, 5}}) {
        CHECK(first({1, 1, 3}, -z, up, Sides::front) == 3);
        CHECK(first({1, 1, 3}, -z, up, Sides::back) == -1);
        CHECK(first({1, 1, -3}, z, up, Sides::front) == -1);
        CHECK(first({1, 1, -3}, z, up, Sides::back) == 3);
    }
}

TEST_CASE("oracle: a mirror carries a shape's front along") {
    const Affine mirror{{Vec3f{-1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}}, {0, 0, 0}};
    for (const Shape& up :
         std::vector<Shape>{Triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, Disk{{1, 1, 0}, {0, 0, 1}, 5}}) {
        CHECK(first({-1, 1, 3}, -z, up, Sides::front, mirror) == 3);
        CHECK(first({-1, 1, 3}, -z, up, Sides::back, mirror) == -1);
    }
}

TEST_CASE("oracle: a closed surface shows its front from outside, its back from inside and through its front") {
    for (const Shape& shape : std::vector<Shape>{Sphere{{0, 0, 0}, 5}, Ellipsoid{{0, 0, 0}, {5, 6, 7}},
                                                 Cylinder{{0, 0, -4}, {0, 0, 4}, 5, Ends::capped},
                                                 Hyperboloid{{0, 0, -4}, {0, 0, 4}, 5, 6, Ends::capped}}) {
        CHECK(first({-10, 0, 0}, x, shape, Sides::front) == 5);
        CHECK(first({-10, 0, 0}, x, shape, Sides::back) == 15);
        CHECK(first({0, 0, 0}, x, shape, Sides::front) == -1);
        CHECK(first({0, 0, 0}, x, shape, Sides::back) == 5);
    }
}

TEST_CASE("oracle: caps face away from the shape") {
    const Cylinder capped{{0, 0, 0}, {0, 0, 4}, 5, Ends::capped};
    CHECK(first({1, 0, 9}, -z, capped, Sides::front) == 5);
    CHECK(first({1, 0, 9}, -z, capped, Sides::back) == 9);
    CHECK(first({1, 0, -9}, z, capped, Sides::front) == 9);
    CHECK(first({1, 0, 2}, z, capped, Sides::front) == -1);
    CHECK(first({1, 0, 2}, z, capped, Sides::back) == 2);
}

TEST_CASE("oracle: a tangent and an apex are seen from both sides") {
    for (const Sides sides : {Sides::front, Sides::back}) {
        CHECK(first({-10, 5, 0}, x, Sphere{{0, 0, 0}, 5}, sides) == 10);
        CHECK(first({-10, 0, 4}, x, Cone{{0, 0, 0}, {0, 0, 4}, 4, 0}, sides) == 10);
        CHECK(first({0, -10, 2}, y, Cylinder{{0, 0, 0}, {0, 0, 4}, 0}, sides) == 10);
    }
}

TEST_CASE("oracle: an open surface shows its back through its open end") {
    const Paraboloid bowl{{0, 0, 0}, {0, 0, 4}, 4};
    CHECK(first({0, 0, 9}, -z, bowl, Sides::back) == 9);
    CHECK(first({0, 0, 9}, -z, bowl, Sides::front) == -1);
    CHECK(first({0, 0, -9}, z, bowl, Sides::front) == 9);
}
