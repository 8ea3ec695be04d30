#include "catch.h"
#include "geometry/every_shape.h"
#include "geometry/verdict.h"
#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/bounds/hull.h"
#include "raylab/geometry/placement_at.h"

#include <algorithm>

// Rays and shapes that move: where a shape stands at a ray's float time is exact, and so is every decision about it.

using namespace raylab;
using namespace raylab::adversarial;
using raylab::adversarial::Draw;

namespace {

struct Moving {
    Object object;  // with a motion
    float time;

    const Motion& motion() const { return *object.motion; }
    Vec3d place_of(const Vec3d& p) const {
        const auto [columns, translation] = placement_at<double>(object.placement, motion(), time);
        return columns[0] * p.x + columns[1] * p.y + columns[2] * p.z + translation;
    }
};

Moving moving(Draw& draw, Shape shape) {
    Moving result{object(std::move(shape)), any_time(draw)};
    result.object.sides = any_sides(draw);
    do {
        result.object.placement = any_placement(draw);
        result.object.motion = any_motion(draw);
    } while (is_singular_at(result.object.placement, result.motion(), result.time));
    return result;
}

std::optional<std::string> wrong(const Ray& ray, const Moving& it) {
    const auto& [shape, placement, front, back, sides, shading, path, motion] = it.object;
    DecisionCounts decisions;
    auto found = fault(ray, oracle::intersect(in<double>(ray), shape, placement, *motion, ray.time, sides),
                       intersect(ray, shape, placement, *motion, decisions, sides));
    if (found) *found += fmt::format(" for shape {}", shape.index());
    return found;
}

// The answer, and half the time, where there is a hit, that in a range that ends about it.
std::optional<std::string> judge(Draw& draw, Ray ray, const Moving& it) {
    ray.time = it.time;
    if (auto found = wrong(ray, it)) return found;
    DecisionCounts decisions;
    const auto hit = intersect(ray, it.object.shape, it.object.placement, it.motion(), decisions, it.object.sides);
    if (!hit || draw.one_in(2)) return std::nullopt;
    ray.range = tight_range(draw, cast<float>(hit->t));
    return wrong(ray, it);
}

Ray toward(Draw& draw, const Vec3d& point) {
    if (draw.one_in(4)) return {convert<float>(point), draw.lattice_direction(2)};  // it begins there, or nearly
    return through(any_point(draw), point);
}

// At a point of an edge, or at a corner, of a triangle where it is at the ray's time.
std::optional<std::string> at_an_edge(Draw& draw) {
    const auto corner = [&] { return draw.one_in(2) ? draw.on_lattice(-3, 3) : draw.in_cube(1); };
    const Triangle triangle{corner(), corner(), corner()};
    const Moving it = moving(draw, triangle);
    const double weight = draw.one_in(3) ? 0 : draw.number(0, 1);
    const Vec3d at = convert<double>(triangle.a) * (1 - weight) + convert<double>(triangle.b) * weight;
    return judge(draw, toward(draw, it.place_of(at)), it);
}

// Past a sphere that keeps its shape, as close to its silhouette as floats allow.
std::optional<std::string> at_a_silhouette(Draw& draw) {
    const Sphere sphere{any_point(draw), any_radius(draw)};
    Moving it = moving(draw, sphere);
    it.object.placement.columns = Affine{}.columns;
    it.object.motion->columns = Motion{}.columns;
    const Vec3d center = it.place_of(convert<double>(sphere.center));
    const Vec3f origin = any_point(draw);
    const Vec3d way = center - convert<double>(origin);
    const Vec3d aside = cross(way, convert<double>(draw.lattice_direction(2)));
    if (!(dot(aside, aside) > 0) || !(dot(way, way) > sphere.radius * sphere.radius)) return std::nullopt;
    // The tangents from the origin touch a circle about the way to the center.
    const double d2 = dot(way, way), r2 = double{sphere.radius} * sphere.radius;
    const Vec3d touched = center - way * (r2 / d2) + glm::normalize(aside) * (sphere.radius * std::sqrt(1 - r2 / d2));
    return judge(draw, through(origin, touched), it);
}

std::optional<std::string> at_any_shape(Draw& draw) {
    const Moving it = moving(draw, shape_of_every_kind(draw));
    return judge(draw, toward(draw, it.place_of(convert<double>(any_point(draw)))), it);
}

// Everything in one unit of length that is a power of two, and what moves in one of time.
std::optional<std::string> of_any_exponent(Draw& draw) {
    Moving it = moving(draw, shape_of_every_kind(draw));
    Ray ray = toward(draw, it.place_of(convert<double>(any_point(draw))));
    const float length = std::ldexp(1.0f, draw.integer(-100, 90)), seconds = std::ldexp(1.0f, draw.integer(-30, 30));
    for (Vec3f& column : it.object.placement.columns) column = scaled(column, length);
    it.object.placement.translation = scaled(it.object.placement.translation, length);
    for (Vec3f& column : it.object.motion->columns) column = scaled(column, length / seconds);
    it.object.motion->translation = scaled(it.object.motion->translation, length / seconds);
    it.time *= seconds;
    if (is_singular_at(it.object.placement, it.motion(), it.time)) return std::nullopt;  // something underflowed
    ray.origin = scaled(ray.origin, length);
    ray.direction = scaled(ray.direction, draw.one_in(2) ? length : std::ldexp(1.0f, draw.integer(-120, 100)));
    if (ray.direction == Vec3f(0)) return std::nullopt;
    return judge(draw, ray, it);
}

std::optional<std::string> in_any_way(Draw& draw) {
    switch (draw.integer(0, 3)) {
        case 0:
            return at_an_edge(draw);
        case 1:
            return at_a_silhouette(draw);
        case 2:
            return at_any_shape(draw);
        default:
            return of_any_exponent(draw);
    }
}

}  // namespace

TEST_CASE("ray against moving shapes: every decision is the exact one, and t within one float of exact") {
    CHECK(faults(100'000, in_any_way) == "");
}

TEST_CASE("a moving shape is hit inside its box of the ray's time, and inside what its hull sweeps over") {
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        Moving it = moving(draw, shape_of_every_kind(draw));
        if (draw.one_in(2)) it.object.motion->columns = Motion{}.columns;
        const auto& [shape, placement, front, back, sides, shading, path, motion] = it.object;
        if (is_singular_at(placement, *motion, it.time)) return std::nullopt;
        Ray ray = toward(draw, it.place_of(convert<double>(any_point(draw))));
        ray.time = it.time;
        DecisionCounts decisions;
        const auto hit = intersect(ray, shape, placement, *motion, decisions, sides);
        const auto box = bounds(shape, placement, *motion, it.time);
        if (!hit || !box) return std::nullopt;
        const bool translates = only_translates(*motion);
        const Hull over_time = translates ? swept(hull(shape, placement), motion->translation, {0, 1}) : Hull{};
        for (int axis = 0; axis < 3; ++axis) {
            const double x = ray.origin[axis] + hit->t * ray.direction[axis];
            const double slack = 1e-12 * (1 + std::abs(x));  // of x as computed here
            bool inside = x >= box->min[axis] - slack && x <= box->max[axis] + slack;
            const auto reaches = [&](double sign) {
                return std::ranges::any_of(over_time, [&](const Ball& ball) {
                    return sign * (ball.center[axis] - x) + ball.radius >= -slack;
                });
            };
            inside = inside && (!translates || (reaches(1) && reaches(-1)));
            if (!inside) return fmt::format("shape {}: {}", shape.index(), adversarial::words(ray));
        }
        return std::nullopt;
    };
    CHECK(faults(50'000, judge) == "");
}

TEST_CASE("a million rays against moving shapes", "[.million]") { CHECK(faults(1'000'000, in_any_way) == ""); }
