#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/geometry/bounds/bounding_sphere.h"
#include "raylab/geometry/bounds/slabs.h"
#include "raylab/number/dyadic.h"

using namespace raylab;
using namespace raylab::adversarial;

namespace {

// Some balls, now and then concentric; their radii are from as small as the last bits of the coordinates to as large as
// the whole set.
Hull balls(Draw& draw) {
    const bool together = draw.one_in(3);
    const Vec3f at = draw.in_cube(1e3);
    Hull hull;
    for (int count = draw.integer(1, 12); count > 0; --count) {
        const Vec3f center = together ? at : at + draw.in_cube(1);
        hull.push_back({convert<double>(center), std::ldexp(draw.uniform(0, 1), draw.integer(-20, 10))});
    }
    return hull;
}

Dyadic square(const Vec3<Dyadic>& v) { return dot(v, v); }

// A ball lies in a sphere whose radius is larger by at least the distance of their centers.
bool holds(const Sphere& sphere, const Ball& ball) {
    if (std::isinf(sphere.radius)) return sphere.radius > 0;
    const Dyadic room = Dyadic(sphere.radius) - Dyadic(ball.radius);
    if (sign(room) == Sign::negative) return false;
    return sign(square(convert<Dyadic>(ball.center) - convert<Dyadic>(sphere.center)) - room * room) != Sign::positive;
}

// A ball lies between two planes if its center is at least radius |axis| from each.
bool holds(const Slabs& slabs, const Ball& ball) {
    const auto from = convert<Dyadic>(ball.center) - convert<Dyadic>(slabs.center);
    for (std::size_t i = 0; i < 3; ++i) {
        const float half = slabs.half[static_cast<int>(i)];
        if (std::isinf(half)) continue;
        const auto axis = convert<Dyadic>(slabs.axes[i]);
        const Dyadic along = dot(axis, from), reach = Dyadic(ball.radius) * Dyadic(ball.radius) * square(axis);
        for (const Dyadic& room : {Dyadic(half) - along, Dyadic(half) + along})
            if (sign(room) == Sign::negative || sign(room * room - reach) == Sign::negative) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("a bounding sphere and bounding slabs hold every ball exactly, whatever its radius") {
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        const Hull hull = balls(draw);
        const Sphere sphere = bounding_sphere(hull);
        const Slabs slabs = bounding_slabs(hull);
        for (const Ball& ball : hull) {
            if (!holds(sphere, ball)) return "outside of the sphere";
            if (!holds(slabs, ball)) return "outside of the slabs";
        }
        return std::nullopt;
    };
    CHECK(faults(10'000, judge) == "");
}
