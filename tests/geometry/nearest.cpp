#include "raylab/geometry/intersect/nearest.h"

#include "catch.h"
#include "raylab/number/next_float.h"

using namespace raylab;

namespace {

const Affine in_place;

Target target_of(const Shape& triangle) { return {&triangle, 0, &in_place, Sides::both}; }

// The order of a ray's hits of two triangles that it surely hits.
Sign order_of(const Ray& ray, const Triangle& one, const Triangle& other) {
    const Shape a = one, b = other;
    DecisionCounts decisions;
    const auto at_a = intersect(ray, target_of(a), decisions), at_b = intersect(ray, target_of(b), decisions);
    REQUIRE((at_a && at_b));
    return order(ray, target_of(a), *at_a, target_of(b), *at_b, decisions);
}

Triangle turned(const Triangle& t, int axis) {
    const auto turn = [&](Vec3f v) { return Vec3f(v[axis], v[(axis + 1) % 3], v[(axis + 2) % 3]); };
    return {turn(t.a), turn(t.b), turn(t.c)};
}

}  // namespace

TEST_CASE("of two triangles in one plane across an axis a ray hits neither sooner") {
    constexpr float at = 0.1f;
    const Triangle floor{{-9, -7, at}, {9, -7, at}, {0, 11, at}}, tile{{-1, -1, at}, {1.3f, -1, at}, {0, 1, at}};
    for (int axis = 0; axis < 3; ++axis) {
        Ray ray{{0.3f, 0.2f, 5}, {-0.06f, -0.05f, -1}};
        ray = {turned({ray.origin, ray.direction, {}}, axis).a, turned({ray.origin, ray.direction, {}}, axis).b};
        CHECK(order_of(ray, turned(floor, axis), turned(tile, axis)) == Sign::zero);
    }
}

TEST_CASE("a triangle that leaves that plane by the least that floats tell is hit sooner or later") {
    constexpr float at = 0.1f;
    const float above = next_above(at);
    const Triangle floor{{-9, -7, at}, {9, -7, at}, {0, 11, at}};
    const Ray ray{{0.3f, 0.2f, 5}, {-0.06f, -0.05f, -1}};
    for (int corner = 0; corner < 3; ++corner) {
        Triangle tile{{-1, -1, at}, {1.3f, -1, at}, {0, 1, at}};
        (corner == 0 ? tile.a : corner == 1 ? tile.b : tile.c).z = above;
        CHECK(order_of(ray, floor, tile) == Sign::positive);
        CHECK(order_of(ray, tile, floor) == Sign::negative);
    }
}
