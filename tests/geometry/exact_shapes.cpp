#include "catch.h"
#include "geometry/every_shape.h"
#include "geometry/verdict.h"
#include "raylab/geometry/bounds/box.h"

using namespace raylab;
using namespace raylab::adversarial;
using raylab::adversarial::Draw;

namespace {

std::optional<std::string> wrong(const Ray& ray, const Object& object) {
    DecisionCounts decisions;
    auto found = fault(ray, oracle::intersect(in<double>(ray), object.shape, object.placement, object.sides),
                       intersect(ray, object.shape, object.placement, decisions, object.sides));
    if (found) *found += fmt::format(" for shape {}", object.shape.index());
    return found;
}

// Aimed at the shape: at one of the points it is defined by, at another point near it, or along its axis.
Ray aimed(Draw& draw, const Object& target) {
    const auto placed = [&](const Vec3f& p) { return transform_point(target.placement, convert<double>(p)); };
    if (draw.one_in(3)) return {convert<float>(placed(any_point(draw))), draw.lattice_direction(2)};
    return through(any_point(draw), placed(any_point(draw)));
}

std::optional<std::string> judge_one(Draw& draw, const Object& target) {
    Ray ray = aimed(draw, target);
    if (auto found = wrong(ray, target)) return found;
    DecisionCounts decisions;
    const auto hit = intersect(ray, target.shape, target.placement, decisions, target.sides);
    if (!hit || draw.one_in(2)) return std::nullopt;
    ray.range = tight_range(draw, cast<float>(hit->t));
    return wrong(ray, target);
}

}  // namespace

TEST_CASE("ray against every shape at its place: every decision is the exact one, and t within one float of exact") {
    CHECK(faults(60'000, [](Draw& draw) { return judge_one(draw, object_of_every_kind(draw)); }) == "");
}

TEST_CASE("ray against every shape over the whole range of floats") {
    const auto judge = [](Draw& draw) {
        Object target = object_of_every_kind(draw);
        const float scale = cast<float>(std::pow(10.0, draw.integer(-30, 30)));
        for (Vec3f& column : target.placement.columns) column = scaled(column, scale);
        target.placement.translation = scaled(target.placement.translation, scale);
        if (is_singular(target.placement)) return std::optional<std::string>();
        return judge_one(draw, target);
    };
    CHECK(faults(20'000, judge) == "");
}

TEST_CASE("ray against placed triangles, at their edges: every decision is the exact one") {
    const auto judge = [](Draw& draw) {
        const Triangle triangle{draw.in_cube(1), draw.in_cube(1), draw.in_cube(1)};
        Object target = object(triangle, any_placement(draw));
        target.sides = any_sides(draw);
        if (draw.one_in(4)) target.placement.translation = draw.in_cube(1e4f);
        const auto placed = [&](const Vec3f& v) { return transform_point(target.placement, convert<double>(v)); };
        const double weight = draw.one_in(3) ? 0 : draw.number(0, 1);
        const Vec3d at_edge = placed(triangle.a) * (1 - weight) + placed(triangle.b) * weight;
        const Ray ray = through(convert<float>(at_edge + convert<double>(draw.in_cube(3))), at_edge);
        return wrong(ray, target);
    };
    CHECK(faults(60'000, judge) == "");
}

TEST_CASE("every hit lies in the bounds of its shape") {
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        const Object target = object(shape_of_every_kind(draw), any_placement(draw));
        const auto box = bounds(target.shape, target.placement);
        if (!box)
            return std::holds_alternative<Plane>(target.shape) ? std::nullopt : std::optional<std::string>("unbounded");
        const Ray ray = aimed(draw, target);
        DecisionCounts decisions;
        const auto hit = intersect(ray, target.shape, target.placement, decisions);
        if (!hit) return std::nullopt;
        for (int axis = 0; axis < 3; ++axis) {
            const double x = ray.origin[axis] + hit->t * ray.direction[axis];
            const double slack = 1e-12 * (1 + std::abs(x));  // of x as computed here
            if (x < box->min[axis] - slack || x > box->max[axis] + slack)
                return fmt::format("shape {}: {}", target.shape.index(), adversarial::words(ray));
        }
        return std::nullopt;
    };
    CHECK(faults(100'000, judge) == "");
}

TEST_CASE("a ray along a capped cone's generator hits the base's rim and not the apex") {
    const Cone cone{{0, 0, 0}, {0, 0, 4}, 4, 0, Ends::capped};
    DecisionCounts decisions;
    const Ray from_above{{-4, 0, 8}, {1, 0, -1}};  // through the apex at t = 4, the rim at t = 8
    CHECK(intersect(from_above, cone, {}, decisions).value().t == 8);
    CHECK(oracle::intersect(in<double>(from_above), cone).t->nearest() == 8);
}
