#include "catch.h"

#include "raylab/geometry/oracle/oracle.h"

#include <cmath>
#include <limits>

using namespace raylab;
using oracle::HitKind;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

oracle::Answer intersect_unit(Vec3d origin, Vec3d direction, Interval<double> range = {0, infinity}) {
    return oracle::intersect(RayOf<double>{origin, direction, range}, SphereOf<double>{{0, 0, 0}, 1});
}

oracle::ExactT t_along_x(Vec3d origin, double speed, const SphereOf<double>& sphere) {
    return oracle::intersect(RayOf<double>{origin, {speed, 0, 0}, {0, infinity}}, sphere).t.value();
}

}  // namespace

TEST_CASE("oracle: a ray through a sphere hits its near side") {
    const auto answer = intersect_unit({-3, 0, 0}, {2, 0, 0});
    CHECK(answer.hit_kind == HitKind::interior);
    CHECK(is_eq(answer.t.value().compare(1.0)));
}

TEST_CASE("oracle: from inside, and from the sphere itself, the nearest hit is in the closed range") {
    CHECK(is_eq(intersect_unit({0, 0, 0}, {0, 2, 0}).t.value().compare(0.5)));
    CHECK(is_eq(intersect_unit({1, 0, 0}, {-1, 0, 0}).t.value().compare(0.0)));
    CHECK(is_eq(intersect_unit({1, 0, 0}, {-1, 0, 0}, {std::numeric_limits<double>::denorm_min(), infinity})
                    .t.value()
                    .compare(2.0)));
    CHECK_FALSE(intersect_unit({0, 0, 0}, {0, 2, 0}, {0, std::nextafter(0.5, 0.0)}).hit());
}

TEST_CASE("oracle: Pythagorean tangents touch, and the next double beside them does not") {
    const SphereOf<double> sphere{{0, 0, 7}, 5};
    const Vec3d touching(3, 4, 7), along(4, -3, 0);
    const auto at = [&](Vec3d origin) {
        return oracle::intersect(RayOf<double>{origin, along, {-infinity, infinity}}, sphere);
    };
    const auto answer = at(touching - 2.0 * along);
    CHECK(answer.hit_kind == HitKind::tangent);
    CHECK(is_eq(answer.t.value().compare(2.0)));
    CHECK(at({std::nextafter(3.0, 4.0), 4, 7}).hit_kind == HitKind::miss);
    CHECK(at({std::nextafter(3.0, 2.0), 4, 7}).hit_kind == HitKind::interior);
}

TEST_CASE("oracle: an irrational hit is ordered against doubles and against other roots") {
    // t^2 - 2 t + 1/4 = 0 at 1 -+ sqrt(3)/2
    const SphereOf<double> unit{{0, 0, 0}, 1};
    const auto t = t_along_x({-1, 0.5, 0}, 1, unit);
    CHECK(t.nearest() == 0.13397459621556135);  // 0.133974596215561353236...
    CHECK(t.to_string() == "0.13397459621556135 (smaller root of 4 t^2 - 8 t + 1)");
    CHECK(is_eq(t.compare(t)));
    CHECK(is_gt(t.compare(std::nextafter(t.nearest(), 0.0))));
    CHECK(is_lt(t.compare(std::nextafter(t.nearest(), 1.0))));
    CHECK(is_eq(t.compare(t_along_x({-2, 1, 0}, 2, {{0, 0, 0}, 2}))));
    const auto sooner = t_along_x({-1, std::nextafter(0.5, 0.0), 0}, 1, unit);
    CHECK(is_lt(sooner.compare(t)));
}

TEST_CASE("oracle: the small root of x^2 - 2 x + 1e-8 is right where the textbook formula loses it") {
    // A ray along x past a unit sphere at (1, 1e-4): (t - 1)^2 + 1e-8 = 1. The small root is c/2 + c^2/8 + ...
    const auto t = t_along_x({0, 0, 0}, 1, {{1, 1e-4, 0}, 1});
    CHECK_THAT(t.nearest(), WithinRel(5.0000000125e-9, 1e-12));
}

TEST_CASE("oracle: a sphere of radius zero is its center; one of negative radius is nothing") {
    const RayOf<double> through{{0, 0, 0}, {1, 1, 1}, {0, infinity}};
    const auto point = oracle::intersect(through, SphereOf<double>{{2, 2, 2}, 0});
    CHECK(point.hit_kind == HitKind::tangent);
    CHECK(is_eq(point.t.value().compare(2.0)));
    CHECK(oracle::intersect(through, SphereOf<double>{{2, 2, 2.5}, 0}).hit_kind == HitKind::miss);
    CHECK(oracle::intersect(through, SphereOf<double>{{2, 2, 2}, -1}).hit_kind == HitKind::miss);
}

TEST_CASE("oracle: a sphere hit only behind the range keeps its class and has no t") {
    const auto answer = intersect_unit({-3, 0, 0}, {-1, 0, 0});
    CHECK(answer.hit_kind == HitKind::interior);
    CHECK_FALSE(answer.hit());
}
