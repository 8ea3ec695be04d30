#include "catch.h"

#include "raylab/geometry/oracle/oracle.h"
#include "raylab/sampling/sequence.h"

#include <array>
#include <cstdint>
#include <limits>

using namespace raylab;
using oracle::HitKind;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const TriangleOf<double> right_angled{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

RayOf<double> ray(Vec3d origin, Vec3d direction, Interval<double> range = {0, infinity}) {
    return {origin, direction, range};
}
RayOf<double> down_at(double x, double y) { return ray({x, y, 2}, {0, 0, -1}); }

HitKind hit_kind(const RayOf<double>& r, const TriangleOf<double>& triangle = right_angled) {
    return oracle::intersect(r, triangle).hit_kind;
}

// A second opinion in whole numbers, by the scalar triple products of the origin and two vertices.
using Whole = std::array<std::int64_t, 3>;
Whole minus(const Whole& a, const Whole& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
std::int64_t triple(const Whole& a, const Whole& b, const Whole& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}
HitKind in_whole_numbers(const Whole& origin, const Whole& d, const std::array<Whole, 3>& vertices) {
    const Whole a = minus(vertices[0], origin), b = minus(vertices[1], origin), c = minus(vertices[2], origin);
    const auto u = triple(d, b, c), v = triple(d, c, a), w = triple(d, a, b);
    const Whole ab = minus(b, a), ac = minus(c, a);
    const bool degenerate =
        triple({1, 0, 0}, ab, ac) == 0 && triple({0, 1, 0}, ab, ac) == 0 && triple({0, 0, 1}, ab, ac) == 0;
    if (degenerate) return HitKind::miss;
    if (u == 0 && v == 0 && w == 0) return HitKind::within;
    const bool outside = (u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0);
    if (outside || u + v + w == 0) return HitKind::miss;
    return u == 0 || v == 0 || w == 0 ? HitKind::boundary : HitKind::interior;
}

}  // namespace

TEST_CASE("oracle: a ray through the inside of a triangle hits at its exact t") {
    const auto answer = oracle::intersect(ray({1, 1, 2}, {0, 0, -3}), right_angled);
    CHECK(answer.hit_kind == HitKind::interior);
    REQUIRE(answer.hit());
    CHECK(is_neq(answer.t->compare(2.0 / 3.0)));
    CHECK(answer.t->nearest() == 2.0 / 3.0);
    CHECK(answer.t->to_string() == "0.6666666666666666 (2/3)");
}

TEST_CASE("oracle: edges and vertices belong to a triangle and are its boundary") {
    for (const auto& [x, y] : {std::pair{2.0, 0.0}, {0.0, 2.0}, {2.0, 2.0}, {0.0, 0.0}, {4.0, 0.0}, {0.0, 4.0}}) {
        const auto answer = oracle::intersect(down_at(x, y), right_angled);
        CHECK(answer.hit_kind == HitKind::boundary);
        REQUIRE(answer.hit());
        CHECK(is_eq(answer.t->compare(2.0)));
    }
}

TEST_CASE("oracle: the smallest step outside an edge misses, inside it is interior") {
    const double outside = std::nextafter(4.0, 5.0) - 2, inside = std::nextafter(4.0, 3.0) - 2;
    CHECK(hit_kind(down_at(2, outside)) == HitKind::miss);
    CHECK(hit_kind(down_at(2, inside)) == HitKind::interior);
    CHECK(hit_kind(down_at(2, -std::numeric_limits<double>::denorm_min())) == HitKind::miss);
    CHECK(hit_kind(down_at(2, std::numeric_limits<double>::denorm_min())) == HitKind::interior);
}

TEST_CASE("oracle: a coplanar ray is within, even if it passes over an edge or a vertex, and is no hit") {
    for (const Vec3d& direction : {Vec3d(1, 0, 0), Vec3d(1, 1, 0), Vec3d(0, -1, 0)}) {
        const auto answer = oracle::intersect(ray({-1, 0, 0}, direction), right_angled);
        CHECK(answer.hit_kind == HitKind::within);
        CHECK_FALSE(answer.hit());
    }
}

TEST_CASE("oracle: a ray parallel to the triangle beside its plane misses") {
    CHECK(hit_kind(ray({-1, 1, 1e-300}, {1, 0, 0})) == HitKind::miss);
}

TEST_CASE("oracle: a triangle without area is never hit") {
    const TriangleOf<double> segment{{0, 0, 0}, {1, 1, 0}, {3, 3, 0}}, point{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}};
    for (const auto& triangle : {segment, point}) {
        CHECK(hit_kind(down_at(1, 1), triangle) == HitKind::miss);
        CHECK(hit_kind(ray({0, 0, 0}, {1, 1, 0}), triangle) == HitKind::miss);
    }
}

TEST_CASE("oracle: the range is closed and exact at both ends") {
    CHECK(oracle::intersect(ray({1, 1, 2}, {0, 0, -1}, {2, 2}), right_angled).hit());
    CHECK_FALSE(oracle::intersect(ray({1, 1, 2}, {0, 0, -1}, {0, std::nextafter(2.0, 0.0)}), right_angled).hit());
    CHECK_FALSE(
        oracle::intersect(ray({1, 1, 2}, {0, 0, -1}, {std::nextafter(2.0, 3.0), infinity}), right_angled).hit());
    CHECK(oracle::intersect(ray({1, 1, 0}, {0, 0, -1}), right_angled).hit());
}

TEST_CASE("oracle: one third is above the float below it and below the float above it") {
    const auto third = oracle::intersect(ray({1, 1, 1}, {0, 0, -3}), right_angled).t.value();
    CHECK(is_lt(third.compare(std::nextafter(1.0 / 3.0, 1.0))));
    CHECK(is_gt(third.compare(1.0 / 3.0)));
    CHECK_FALSE(oracle::intersect(ray({1, 1, 1}, {0, 0, -3}, {0, 1.0 / 3.0}), right_angled).hit());
}

TEST_CASE("oracle: a hit outside the range keeps its class and has no t") {
    const auto behind = oracle::intersect(ray({2, 0, 2}, {0, 0, 1}), right_angled);
    CHECK(behind.hit_kind == HitKind::boundary);
    CHECK_FALSE(behind.hit());
}

TEST_CASE("oracle: a direction is a free vector, however small beside its origin") {
    const TriangleOf<double> far{{1e6, 0, 0}, {1e6 + 4, 0, 0}, {1e6, 4, 0}};
    const auto answer = oracle::intersect(ray({1e6 + 1, 1, 1e-20}, {1e-20, 1e-20, -1e-20}), far);
    CHECK(answer.hit_kind == HitKind::interior);
    CHECK(is_eq(answer.t.value().compare(1.0)));
}

TEST_CASE("oracle: every class of lattice meetings is the one found in whole numbers") {
    RandomSequence random(7, 0);
    const auto whole = [&](int low, int high) {
        return Whole{random.whole(low, high), random.whole(low, high), random.whole(low, high)};
    };
    const auto real = [](const Whole& w) { return Vec3d(w[0], w[1], w[2]); };
    std::array<int, 5> seen{};
    int wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::array<Whole, 3> corner{whole(0, 4), whole(0, 4), whole(0, 4)};
        const Whole origin = whole(0, 4), direction = whole(-2, 2);
        if (direction == Whole{}) continue;
        const HitKind found =
            hit_kind(ray(real(origin), real(direction)), {real(corner[0]), real(corner[1]), real(corner[2])});
        wrong += found != in_whole_numbers(origin, direction, corner);
        ++seen[static_cast<std::size_t>(found)];
    }
    CHECK(wrong == 0);
    for (const HitKind each : {HitKind::miss, HitKind::interior, HitKind::boundary, HitKind::within})
        CHECK(seen[static_cast<std::size_t>(each)] > 100);
}
