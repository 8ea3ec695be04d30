#include "raylab/geometry/filter/revolution_filter.h"
#include "catch.h"
#include "geometry/filter_fault.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"

#include <atomic>

using namespace raylab;
using namespace raylab::adversarial;

namespace {

// A ray from anywhere, or from a point near the surface, half of these from one that is on it up to rounding.
template <class S>
Ray near(Draw& draw, const S& shape) {
    if (draw.one_in(3)) return through(any_point(draw), convert<double>(any_point(draw)));
    const Vec3d base = convert<double>(shape.base), axis = convert<double>(shape.top) - base;
    const Vec3d across = cross(axis, convert<double>(draw.in_cube(1)));
    const double size = glm::length(across), s = draw.number(-0.1, 1.1);
    double radius = 0;
    if constexpr (std::same_as<S, Cone>)
        radius = shape.base_radius + (double{shape.top_radius} - shape.base_radius) * s;
    else
        radius = shape.radius;
    const double out = draw.one_in(2) ? 1 : draw.number(0, 2);
    const Vec3d spoke = size > 0 ? across * (radius * out / size) : Vec3d(0);
    return {convert<float>(base + axis * s + spoke), draw.one_in(4) ? draw.lattice_direction(1) : draw.in_cube(1)};
}

struct Seen {
    std::atomic<int> missed = 0, passed = 0;  // counted by several threads
    std::atomic<int> decided = 0, asked = 0;  // of those that do not pass
};

template <class S>
std::optional<std::string> judge(Draw& draw, const S& shape, Seen& seen) {
    const Ray ray = near(draw, shape);
    if (ray.direction == Vec3f(0)) return std::nullopt;
    const bool hit = oracle::intersect(in<double>(ray), Shape(shape), {}, Sides::both).hit();
    const bool passes = std::holds_alternative<Miss>(revolution_filter::decide(ray, shape, Sides::both));
    seen.missed += !hit;
    seen.passed += passes;
    if (!hit || !passes) return std::nullopt;
    return "hit, but surely passed: " + words(ray);
}

// Judges where a ray enters or leaves.
template <class S>
std::optional<std::string> judge_crossing(Draw& draw, const S& shape, Seen& seen) {
    Ray ray = near(draw, shape);
    if (ray.direction == Vec3f(0) || glm::length(shape.top - shape.base) == 0) return std::nullopt;
    if (std::holds_alternative<Miss>(revolution_filter::decide(ray, shape, Sides::both))) return std::nullopt;
    if (draw.one_in(3)) ray.range = {draw.uniform(0, 1), draw.uniform(1, 3)};
    const Sides sides = draw.one_in(2) ? Sides::both : draw.one_in(2) ? Sides::front : Sides::back;
    const FilterVerdict verdict = revolution_filter::decide(ray, shape, sides);
    ++seen.asked;
    if (std::holds_alternative<Undecided>(verdict)) return std::nullopt;
    ++seen.decided;
    return filter_fault(ray, shape, sides, candidate_of(verdict));
}

template <class S>
S scaled_shape(S shape, float by) {
    shape.base = scaled(shape.base, by);
    shape.top = scaled(shape.top, by);
    return shape;
}

}  // namespace

TEST_CASE("a ray that surely passes a cylinder or cone does not hit it, and most that miss one surely pass") {
    Seen seen;
    const auto ends = [](Draw& draw) { return draw.one_in(2) ? Ends::open : Ends::capped; };
    const auto on_cylinder = [&](Draw& draw) {
        return judge(draw, Cylinder{any_point(draw), any_point(draw), any_radius(draw), ends(draw)}, seen);
    };
    const auto on_cone = [&](Draw& draw) {
        return judge(draw, Cone{any_point(draw), any_point(draw), any_radius(draw), any_radius(draw), ends(draw)},
                     seen);
    };
    CHECK(faults(20'000, on_cylinder) == "");
    CHECK(faults(20'000, on_cone) == "");
    CHECK(seen.passed > seen.missed * 3 / 5);
}

TEST_CASE("a ray that surely passes does not hit over the whole range of floats") {
    Seen seen;
    const auto far = [&](Draw& draw) {
        const float by = cast<float>(std::pow(10.0, draw.integer(-30, 30)));
        Cone cone{any_point(draw), any_point(draw), any_radius(draw) * by, any_radius(draw) * by, Ends::capped};
        return judge(draw, scaled_shape(cone, by), seen);
    };
    CHECK(faults(10'000, far) == "");
    CHECK(seen.passed > 0);
}

TEST_CASE(
    "where a ray is said to enter or leave a cylinder or cone it does, by the same part and t as the whole question "
    "has it") {
    Seen seen;
    const auto ends = [](Draw& draw) { return draw.one_in(2) ? Ends::open : Ends::capped; };
    const auto into_cylinder = [&](Draw& draw) {
        return judge_crossing(draw, Cylinder{any_point(draw), any_point(draw), any_radius(draw), ends(draw)}, seen);
    };
    const auto into_cone = [&](Draw& draw) {
        return judge_crossing(
            draw, Cone{any_point(draw), any_point(draw), any_radius(draw), any_radius(draw), ends(draw)}, seen);
    };
    CHECK(faults(10'000, into_cylinder) == "");
    CHECK(faults(10'000, into_cone) == "");
    CHECK(seen.decided > seen.asked * 3 / 5);
}

TEST_CASE("a ray that passes just beside a rim is not said to enter by the cap") {
    // It leaves the side of the unit cylinder at height 1 + 2^-(k + l - 1), above the cap: exactly, in short binary
    // numbers.
    for (int k = 16; k <= 22; ++k)
        for (int l = k - 1; l <= k; ++l) {
            const double a = std::ldexp(1, -k), b = std::ldexp(1, -l);
            const Ray ray{{cast<float>(1 - 4 * (1 - b)), 0, cast<float>(3 + 2 * (a - b))},
                          {1, 0, cast<float>(-0.5 * (1 + a))}};
            const Cylinder cylinder{{0, 0, 0}, {0, 0, 1}, 1, Ends::capped};
            const auto answer = oracle::intersect(in<double>(ray), Shape(cylinder), {}, Sides::both);
            const FilterVerdict verdict = revolution_filter::decide(ray, cylinder, Sides::both);
            INFO("2^-" << k << " and 2^-" << l);
            CHECK_FALSE(answer.hit());
            CHECK_FALSE(std::holds_alternative<Candidate>(verdict));
        }
}

TEST_CASE("a ray from within a cylinder that ends where it leaves that is not said to miss it") {
    for (const Ends ends : {Ends::open, Ends::capped}) {
        const Cylinder cylinder{{0, 0, 0}, {0, 0, 2}, 1, ends};
        Ray ray{{0, 0, 1}, {1, 0, 0}};
        ray.range = {0, 1};
        CHECK(oracle::intersect(in<double>(ray), Shape(cylinder), {}, Sides::both).hit());
        CHECK_FALSE(std::holds_alternative<Miss>(revolution_filter::decide(ray, cylinder, Sides::both)));
    }
}
