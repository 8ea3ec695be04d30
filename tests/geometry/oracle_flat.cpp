#include "catch.h"

#include "raylab/geometry/oracle/oracle.h"
#include "raylab/sampling/sequence.h"

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

using namespace raylab;
using oracle::HitKind;

namespace {

oracle::Answer intersect(Vec3d origin, Vec3d direction, const Shape& shape) {
    return oracle::intersect(RayOf<double>{origin, direction, {0, std::numeric_limits<double>::infinity()}}, shape);
}

/// The answer to a ray straight down from height 2.
oracle::Answer drop(double x, double y, const Shape& shape) { return intersect({x, y, 2}, {0, 0, -1}, shape); }

Polygon flat(const std::vector<std::pair<int, int>>& corners) {
    Polygon polygon;
    for (const auto& [x, y] : corners) polygon.vertices.push_back(Vec3f(x, y, 0));
    return polygon;
}

const Polygon arrow = flat({{0, 0}, {4, 2}, {0, 4}, {2, 2}});  // its notch is at (2, 2)
const Polygon star = flat({{0, 5}, {-3, -4}, {5, 2}, {-5, 2}, {3, -4}});

}  // namespace

TEST_CASE("oracle: a plane is hit by every ray that crosses it, whatever its normal's length") {
    const Plane floor{{7, 1, 8}, {0, 1e-30f, 0}};
    const auto answer = intersect({100, 3, -50}, {5, -0.5, 1}, floor);
    CHECK(answer.hit_kind == HitKind::interior);
    CHECK(is_eq(answer.t.value().compare(4.0)));
    CHECK(intersect({0, 1, 0}, {1, 0, 1}, floor).hit_kind == HitKind::within);
    CHECK(intersect({0, 1.5, 0}, {1, 0, 1}, floor).hit_kind == HitKind::miss);
    CHECK(intersect({0, 3, 0}, {0, -1, 0}, Plane{{0, 0, 0}, {0, 0, 0}}).hit_kind == HitKind::miss);
}

TEST_CASE("oracle: a disk owns its rim") {
    const Disk disk{{1, 1, 0}, {0, 0, 3}, 5};
    CHECK(drop(3, 2, disk).hit_kind == HitKind::interior);
    CHECK(drop(4, 5, disk).hit_kind == HitKind::boundary);
    CHECK(is_eq(drop(4, 5, disk).t.value().compare(2.0)));
    CHECK(drop(4, std::nextafter(5.0, 6.0), disk).hit_kind == HitKind::miss);
    CHECK(intersect({-9, 1, 0}, {1, 0, 0}, disk).hit_kind == HitKind::within);
}

TEST_CASE("oracle: a disk of radius zero is its center; one of negative radius or zero normal is nothing") {
    CHECK(drop(1, 1, Disk{{1, 1, 0}, {0, 0, 1}, 0}).hit_kind == HitKind::boundary);
    CHECK(drop(1, 2, Disk{{1, 1, 0}, {0, 0, 1}, 0}).hit_kind == HitKind::miss);
    CHECK(drop(1, 1, Disk{{1, 1, 0}, {0, 0, 1}, -1}).hit_kind == HitKind::miss);
    CHECK(drop(1, 1, Disk{{1, 1, 0}, {0, 0, 0}, 5}).hit_kind == HitKind::miss);
}

TEST_CASE("oracle: a concave polygon has no inside in its notch") {
    CHECK(drop(3, 2, arrow).hit_kind == HitKind::interior);
    CHECK(drop(1, 0.75, arrow).hit_kind == HitKind::interior);
    CHECK(drop(1, 2, arrow).hit_kind == HitKind::miss);
    CHECK(drop(2, 2, arrow).hit_kind == HitKind::boundary);
    CHECK(drop(1, 3, arrow).hit_kind == HitKind::boundary);
    CHECK(drop(-1, 2, arrow).hit_kind == HitKind::miss);
}

TEST_CASE("oracle: points level with corners do not confuse the even-odd rule") {
    const Polygon comb = flat({{0, 0}, {1, 2}, {2, 0}, {3, 2}, {4, 0}, {4, 4}, {0, 4}});
    CHECK(drop(-1, 0, comb).hit_kind == HitKind::miss);
    CHECK(drop(1, 0, comb).hit_kind == HitKind::miss);
    CHECK(drop(0.5, 2, comb).hit_kind == HitKind::interior);
    CHECK(drop(2, 2, comb).hit_kind == HitKind::interior);
    CHECK(drop(-1, 2, comb).hit_kind == HitKind::miss);
    CHECK(drop(-1, 4, comb).hit_kind == HitKind::miss);
}

TEST_CASE("oracle: the middle of a pentagram is outside by the even-odd rule") {
    CHECK(drop(0, 0, star).hit_kind == HitKind::miss);
    CHECK(drop(0, 3, star).hit_kind == HitKind::interior);
}

TEST_CASE("oracle: a polygon not quite in one plane is cut out of its Newell plane") {
    // Normal (-4, -4, 32): the plane z = (x + y) / 8.
    const Polygon bent{{{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 4, 0}}};
    CHECK(drop(2, 2, bent).hit_kind == HitKind::interior);
    CHECK(is_eq(drop(2, 2, bent).t.value().compare(1.5)));
    CHECK(drop(4, 0, bent).hit_kind == HitKind::boundary);
    CHECK(is_eq(drop(4, 0, bent).t.value().compare(1.5)));
    CHECK(drop(4.5, 0, bent).hit_kind == HitKind::miss);
}

TEST_CASE("oracle: a polygon is cut out along its normal's dominant axis, x before y before z") {
    // Two opposite corners lie off the plane x + y = 4. Seen along x the outline is y = 0..5 below and 1..4 above, seen
    // along y it is x = 0..4 everywhere; turned, the same tie is one of x and z, and of y and z.
    using Arrangement = Vec3f (*)(const Vec3f&);
    for (const Arrangement turned : {Arrangement([](const Vec3f& p) { return p; }),
                                     Arrangement([](const Vec3f& p) { return Vec3f(p.x, p.z, p.y); }),
                                     Arrangement([](const Vec3f& p) { return Vec3f(p.z, p.x, p.y); })}) {
        Polygon upright;
        for (const Vec3f& corner : {Vec3f(4, 0, 0), Vec3f(0, 5, 0), Vec3f(0, 4, 4), Vec3f(4, 1, 4)})
            upright.vertices.push_back(turned(corner));
        const auto at = [&](const Vec3f& point) {
            const Vec3f across(1, 1, 0);
            return intersect(convert<double>(turned(point - across)), convert<double>(turned(across)), upright)
                .hit_kind;
        };
        CHECK(at({-0.5f, 4.5f, 1}) == HitKind::interior);
        CHECK(at({3.875f, 0.125f, 2}) == HitKind::miss);
        CHECK(at({3.5f, 0.5f, 2}) == HitKind::boundary);
    }
}

TEST_CASE("oracle: polygons of fewer than three corners, or without area, are nothing") {
    CHECK(drop(0, 0, Polygon{}).hit_kind == HitKind::miss);
    CHECK(drop(0, 0, flat({{0, 0}})).hit_kind == HitKind::miss);
    CHECK(drop(1, 0, flat({{0, 0}, {2, 0}})).hit_kind == HitKind::miss);
    CHECK(drop(1, 0, flat({{0, 0}, {2, 0}, {4, 0}})).hit_kind == HitKind::miss);
}

TEST_CASE("oracle: a corner given twice changes nothing") {
    const Polygon doubled = flat({{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {0, 4}});
    CHECK(drop(1, 1, doubled).hit_kind == HitKind::interior);
    CHECK(drop(0, 0, doubled).hit_kind == HitKind::boundary);
    CHECK(drop(5, 0, doubled).hit_kind == HitKind::miss);
}

TEST_CASE("oracle: a polygon's inside is where its corners wind an odd number of times") {
    RandomSequence random(11, 0);
    const auto whole = [&] { return random.whole(0, 8); };
    int wrong = 0, inside = 0, outside = 0;
    for (int i = 0; i < 3000; ++i) {
        std::vector<std::pair<int, int>> corners;
        for (int n = random.whole(3, 8); n > 0; --n) corners.emplace_back(whole(), whole());
        const double x = whole(), y = whole();
        const auto answer = drop(x, y, flat(corners));
        if (answer.hit_kind == HitKind::boundary) continue;
        double turned = 0, area = 0;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const auto [ax, ay] = corners[k];
            const auto [bx, by] = corners[(k + 1) % corners.size()];
            const double turn = std::atan2(by - y, bx - x) - std::atan2(ay - y, ax - x);
            turned += std::remainder(turn, 2 * std::numbers::pi);
            area += ax * by - ay * bx;
        }
        const bool odd = area != 0 && std::lround(turned / (2 * std::numbers::pi)) % 2 != 0;
        wrong += odd != answer.hit();
        ++(answer.hit() ? inside : outside);
    }
    CHECK(wrong == 0);
    CHECK(inside > 200);
    CHECK(outside > 200);
}

TEST_CASE("oracle: a mesh is its nearest triangle") {
    auto mesh = std::make_shared<Mesh>();
    mesh->vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 1}, {4, 0, 1}, {0, 4, 1}};
    mesh->faces = {{0, 1, 2}, {3, 4, 5}};
    const std::shared_ptr<const Mesh> two_floors = mesh;
    CHECK(is_eq(drop(1, 1, two_floors).t.value().compare(1.0)));
    CHECK(drop(1, 1, two_floors).hit_kind == HitKind::interior);
    CHECK(is_eq(intersect({1, 1, 0.5}, {0, 0, -1}, two_floors).t.value().compare(0.5)));
    CHECK(drop(3, 3, two_floors).hit_kind == HitKind::miss);
}
