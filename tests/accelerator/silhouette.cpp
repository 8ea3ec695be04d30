#include "raylab/accelerator/light_buffer/silhouette.h"

#include "catch.h"
#include "raylab/experiment/adversarial/adversarial.h"

#include <array>

using namespace raylab;
using namespace raylab::adversarial;

// The blur is large, so that errors of every margin show. The light is at the origin.

namespace {

Vec3d in_ball(Draw& draw, double radius) {
    Vec3d p = convert<double>(draw.in_cube(1));
    while (dot(p, p) > 1) p = convert<double>(draw.in_cube(1));
    return p * radius;
}

struct SeenShape {
    Silhouette::Hull hull;

    Vec3d point(Draw& draw) const {  // of the blurred shape
        Vec3d p{0};
        double sum = 0;
        for (const Vec3d& corner : hull.corners) {
            const double weight = draw.one_in(3) ? 0 : draw.number(0, 1);
            p += corner * weight;
            sum += weight;
        }
        p = sum > 0 ? p / sum : hull.corners[0];
        if (hull.ball > 0) p += glm::normalize(in_ball(draw, 1)) * hull.ball;
        return p + in_ball(draw, hull.blur) * 0.999999;
    }

    // Whether the segment between two points intersects the shape itself.
    bool stops(const Vec3d& from, const Vec3d& to) const {
        const Vec3d way = to - from;
        if (hull.ball > 0) {
            const Vec3d d = from - hull.corners[0];
            const double a = dot(way, way), b = dot(d, way), c = dot(d, d) - hull.ball * hull.ball,
                         root = b * b - a * c;
            if (root < 0) return false;
            const double first = (-b - std::sqrt(root)) / a, second = (-b + std::sqrt(root)) / a;
            return (first >= 0 && first <= 1) || (second >= 0 && second <= 1);
        }
        const auto& v = hull.corners;
        const Vec3d normal = cross(v[1] - v[0], v[2] - v[0]);
        const double t = dot(normal, v[0] - from) / dot(normal, way);
        if (!(t >= 0 && t <= 1)) return false;
        const Vec3d p = from + way * t;
        for (std::size_t i = 0; i < v.size(); ++i)
            if (dot(cross(v[(i + 1) % v.size()] - v[i], p - v[i]), normal) < 0) return false;
        return true;
    }
};

SeenShape any_shape_seen(Draw& draw) {
    SeenShape shape;
    shape.hull.blur = draw.one_in(3) ? 0.001 : draw.number(0, 0.1);
    shape.hull.covers = Silhouette::Hull::Covers::perhaps;
    const Vec3d at = convert<double>(draw.in_cube(2));
    if (draw.one_in(2)) {
        shape.hull.corners = {at};
        shape.hull.ball = draw.number(0.05, 2);
        return shape;
    }
    const Vec3d u = convert<double>(draw.in_cube(4)), v = convert<double>(draw.in_cube(4));
    shape.hull.corners = {at - u - v, at + u, at + v};
    if (draw.one_in(2)) shape.hull.corners = {at - u - v, at + u - v, at + u + v, at - u + v};
    const std::size_t count = shape.hull.corners.size();
    for (std::size_t i = 0; i < count; ++i) shape.hull.edges.push_back({i, (i + 1) % count});
    shape.hull.face_normals = {cross(u, v)};
    return shape;
}

LightPyramid any_pyramid(Draw& draw) {
    const int n = 1 << draw.integer(0, 5);
    const auto at = [&](int i) { return 2.0 * i / n - 1; };
    const int column = draw.integer(0, n - 1), row = draw.integer(0, n - 1);
    return {draw.integer(0, 5), at(column), at(column + 1), at(row), at(row + 1)};
}

bool is_inside(const LightPyramid& pyramid, const Vec3d& p) {
    for (const Vec3d& n : pyramid.outward())
        if (dot(n, p) > 0) return false;
    return true;
}

// A direction in the pyramid, often along its rim.
Vec3d direction(Draw& draw, const LightPyramid& pyramid) {
    const auto between = [&](double a, double b) {
        return draw.one_in(3) ? a : draw.one_in(2) ? b : draw.number(a, b);
    };
    return pyramid.vector(between(pyramid.u_min, pyramid.u_max), between(pyramid.v_min, pyramid.v_max), 1);
}

}  // namespace

TEST_CASE("no point of a blurred shape is where its silhouette says it is not") {
    int outside = 0, outside_by_sides = 0, inside = 0;
    for (std::uint64_t seed = 0; seed < 20'000; ++seed) {
        Draw draw(seed);
        const SeenShape shape = any_shape_seen(draw);
        const Silhouette seen(shape.hull);
        const LightPyramid pyramid = any_pyramid(draw);
        const bool is_outside = seen.is_outside(pyramid);
        outside += is_outside;
        outside_by_sides += seen.is_outside_by_sides(pyramid);
        for (int i = 0; i < 20; ++i) {
            const Vec3d p = shape.point(draw);
            REQUIRE(glm::length(p) >= seen.nearest());
            if (!is_inside(pyramid, p)) continue;
            ++inside;
            INFO("seed " << seed);
            REQUIRE_FALSE(is_outside);
            REQUIRE(pyramid.depth(p) >= seen.min_depth(pyramid));
        }
    }
    CHECK(inside > 10'000);
    CHECK(outside_by_sides > 5'000);
    CHECK(outside > outside_by_sides + 200);
}

TEST_CASE("behind a shape that covers a pyramid every way to the light is stopped, even if it strays") {
    int covers = 0;
    for (std::uint64_t seed = 0; seed < 60'000; ++seed) {
        Draw draw(seed);
        const SeenShape shape = any_shape_seen(draw);
        const LightPyramid pyramid = any_pyramid(draw);
        const auto depth = Silhouette(shape.hull).cover_depth(pyramid);
        if (!depth) continue;
        ++covers;
        for (int i = 0; i < 20; ++i) {
            const double further = draw.one_in(2) ? 1 + 1e-9 : draw.number(1, 3);
            const Vec3d from = direction(draw, pyramid) * (*depth * further);
            Vec3d end =
                // Beside the light by as much as the blur, in front of it by half of that.
                in_ball(draw, shape.hull.blur);
            const double before = dot(end, glm::normalize(from));
            if (before > shape.hull.blur / 2) end -= glm::normalize(from) * (before - shape.hull.blur / 2);
            INFO("seed " << seed);
            REQUIRE(shape.stops(from, end));
        }
    }
    CHECK(covers > 1'000);
}

TEST_CASE("a silhouette's cover is about as large as the shape") {
    const LightPyramid cell{4, 0, 0.125, 0, 0.125};
    Silhouette::Hull ball{
        .corners = {{0.3, 0.3, 5}}, .blur = 1e-4, .ball = 0.52, .covers = Silhouette::Hull::Covers::perhaps};
    CHECK(Silhouette(ball).cover_depth(cell).has_value());
    CHECK(*Silhouette(ball).cover_depth(cell) < 5);
    ball.ball = 0.42;
    CHECK_FALSE(Silhouette(ball).cover_depth(cell));
    ball.ball = 0.52;
    ball.covers = Silhouette::Hull::Covers::never;
    CHECK_FALSE(Silhouette(ball).cover_depth(cell));
}
