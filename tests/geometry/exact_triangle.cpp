#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/experiment/adversarial/adversarial.h"

#include "raylab/geometry/filter/triangle_quick_reject.h"

using namespace raylab;
using namespace raylab::adversarial;

namespace {

struct Case {
    Ray ray;
    Triangle triangle;
};

Vec3d weighted(const Triangle& t, double u, double v) {
    const Vec3d a = convert<double>(t.a), b = convert<double>(t.b), c = convert<double>(t.c);
    return a * (1 - u - v) + b * u + c * v;
}

Triangle any_triangle(Draw& draw) { return {draw.in_cube(1), draw.in_cube(1), draw.in_cube(1)}; }

Case generic(Draw& draw) {
    const Triangle triangle = any_triangle(draw);
    return {through(draw.in_cube(3), weighted(triangle, draw.number(-1, 2), draw.number(-1, 2))), triangle};
}

Case at_edge(Draw& draw) {
    const Triangle triangle = any_triangle(draw);
    return {through(draw.in_cube(3), weighted(triangle, draw.number(0, 1), 0)), triangle};
}

Case at_vertex(Draw& draw) {
    const Triangle triangle = any_triangle(draw);
    return {through(draw.in_cube(3), weighted(triangle, 1, 0)), triangle};
}

Case sliver(Draw& draw) {
    Triangle triangle = any_triangle(draw);
    triangle.c = convert<float>(weighted(triangle, draw.number(0, 1), 0) + convert<double>(draw.in_cube(1e-5)));
    const double u = draw.number(0, 1);
    return {through(draw.in_cube(3), weighted(triangle, u, draw.number(0, 1 - u))), triangle};
}

Case grazing(Draw& draw) {
    const Triangle triangle = any_triangle(draw);
    const Vec3d near_plane =
        weighted(triangle, draw.number(-3, 3), draw.number(-3, 3)) + convert<double>(draw.in_cube(1e-5));
    return {through(convert<float>(near_plane), weighted(triangle, draw.number(0, 1), draw.number(0, 0.3))), triangle};
}

Case in_plane(Draw& draw) {
    Triangle triangle = any_triangle(draw);
    triangle.a.z = triangle.b.z = triangle.c.z = 0.3f;
    Vec3f origin = draw.in_cube(3);
    origin.z = 0.3f;
    return {through(origin, weighted(triangle, draw.number(0, 1), 0)), triangle};
}

Case on_surface(Draw& draw) {
    const Triangle triangle = any_triangle(draw);
    return {{convert<float>(weighted(triangle, draw.number(0, 1), 0)), draw.in_cube(1)}, triangle};
}

Case offset(Draw& draw) {
    const Vec3f far = draw.in_cube(1e4);
    Case c = at_edge(draw);
    for (Vec3f* p : {&c.ray.origin, &c.triangle.a, &c.triangle.b, &c.triangle.c}) *p = *p + far;
    return {through(c.ray.origin, weighted(c.triangle, draw.number(0, 1), 0)), c.triangle};
}

Case from_afar(Draw& draw) {
    const Triangle triangle = any_triangle(draw);
    return {through(draw.in_cube(1e6), weighted(triangle, draw.number(0, 1), 0)), triangle};
}

template <int decimal_exponent>
Case at_scale(Draw& draw) {
    const float scale = cast<float>(std::pow(10.0, decimal_exponent));
    Case c = draw.one_in(2) ? at_edge(draw) : generic(draw);
    for (Vec3f* p : {&c.ray.origin, &c.ray.direction, &c.triangle.a, &c.triangle.b, &c.triangle.c})
        *p = scaled(*p, scale);
    return c;
}

Case lattice(Draw& draw) {
    const auto vertex = [&] { return draw.on_lattice(0, 4); };
    return {{draw.on_lattice(0, 4), draw.lattice_direction(2)}, {vertex(), vertex(), vertex()}};
}

Case whole_range(Draw& draw) {
    const Triangle triangle{draw.anywhere(), draw.anywhere(), draw.anywhere()};
    if (draw.one_in(3)) return {{draw.anywhere(), draw.any_direction()}, triangle};
    const Vec3f origin = draw.anywhere();
    const Vec3d way = weighted(triangle, draw.number(0, 0.5), draw.number(0, 0.5)) - convert<double>(origin);
    const Vec3f direction = convert<float>(way * 0.25);
    return {{origin, direction == Vec3f(0) ? draw.any_direction() : direction}, triangle};
}

// Exact hits with short numbers: t = 1 at a vertex, an edge's middle or inside.
Case representable(Draw& draw) {
    const auto vertex = [&] { return scaled(draw.on_lattice(-64, 64), 1.0f / 16); };
    const Triangle triangle{vertex(), vertex(), vertex()};
    const Vec3f point = draw.one_in(2) ? triangle.a : scaled(triangle.a + triangle.b, 0.5f);
    const Vec3f origin = vertex();
    const Vec3f way = point == origin ? Vec3f(0, 0, 1) : point - origin;
    return {{origin, scaled(way, draw.one_in(2) ? 1.0f : 0.25f)}, triangle};
}

}  // namespace

TEST_CASE("ray against triangle: every decision is the exact one, and t within one float of exact") {
    const auto make =
        GENERATE(generic, at_edge, at_vertex, sliver, grazing, in_plane, on_surface, offset, from_afar, at_scale<-15>,
                 at_scale<13>, at_scale<-38>, at_scale<37>, lattice, whole_range, representable);
    const auto judge = [&](Draw& draw) {
        const auto [ray, triangle] = make(draw);
        return fault_in_ranges(draw, ray, triangle);
    };
    CHECK(faults(62'500, judge) == "");
}

TEST_CASE("the quick rejection in floats misses no triangle that is hit") {
    const auto make =
        GENERATE(generic, at_edge, at_vertex, sliver, grazing, in_plane, on_surface, offset, from_afar, at_scale<-15>,
                 at_scale<13>, at_scale<-38>, at_scale<37>, lattice, whole_range, representable);
    const auto judge = [&](Draw& draw) -> std::optional<std::string> {
        const auto [ray, triangle] = make(draw);
        DecisionCounts decisions;
        const bool missed = TriangleQuickReject(ray, bounds(triangle)).surely_misses(TriangleRows(triangle));
        return missed && intersect(ray, triangle, decisions) ? std::optional(words(ray)) : std::nullopt;
    };
    CHECK(faults(62'500, judge) == "");
}

TEST_CASE(
    "the quick rejection sees nearly every miss of a triangle that is nothing special, and gives up where floats overflow") {
    Draw draw(0);
    int missed = 0, seen = 0, seen_beyond = 0;
    for (int i = 0; i < 10'000; ++i) {
        auto [ray, triangle] = generic(draw);
        DecisionCounts decisions;
        if (intersect(ray, triangle, decisions)) continue;
        ++missed;
        seen += TriangleQuickReject(ray, bounds(triangle)).surely_misses(TriangleRows(triangle));
        ray.direction = scaled(ray.direction, 0x1p60f);
        seen_beyond += TriangleQuickReject(ray, bounds(triangle)).surely_misses(TriangleRows(triangle));
    }
    CHECK(seen > 0.99 * missed);
    CHECK(seen_beyond == 0);
}
