#include "raylab/accelerator/split_tree/clipped_bounds.h"
#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/number/next_float.h"

using namespace raylab;
using namespace raylab::adversarial;

namespace {

bool contains(const Box& box, const Vec3d& p) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(p[axis] >= box.min[axis] && p[axis] <= box.max[axis])) return false;
    return true;
}

// Corners are multiples of 2^-20 below 8 and weights are sixteenths, so that points of the triangle are exact in
// doubles.
Vec3f corner(Draw& draw) {
    const auto number = [&] { return std::ldexp(cast<float>(draw.integer(-(1 << 22), 1 << 22)), -20); };
    return draw.one_in(3) ? draw.on_lattice(-4, 4) : Vec3f(number(), number(), number());
}

std::optional<std::string> lose_a_point(Draw& draw) {
    const float scale = draw.one_in(3) ? std::ldexp(1.0f, draw.integer(-100, 80)) : 1;
    const Triangle t{corner(draw) * scale, corner(draw) * scale, corner(draw) * scale};
    const Vec3f p = corner(draw) * scale, q = corner(draw) * scale;
    Box inside = unite({p, p}, {q, q});
    const int i = draw.integer(0, 16), j = draw.integer(0, 16 - i);
    const Vec3d point =
        (convert<double>(t.a) * (16.0 - i - j) + convert<double>(t.b) * double(i) + convert<double>(t.c) * double(j)) /
        16.0;
    for (int axis = 0; axis < 3; ++axis) {  // a side of the box often goes exactly through the point
        if (draw.one_in(3)) inside.min[axis] = float_beyond(point[axis] * (1 + 1e-12), -1);
        if (draw.one_in(3)) inside.max[axis] = std::max(inside.min[axis], cast<float>(point[axis]));
    }
    if (!contains(inside, point) || contains(clipped_bounds(t, inside), point)) return std::nullopt;
    return "a point of the triangle inside the box is not inside its clipped bounds";
}

}  // namespace

TEST_CASE("clipped bounds hold every point of the triangle inside the box") {
    CHECK(faults(200'000, lose_a_point) == "");
}

TEST_CASE("clipped bounds are as tight as floats allow") {
    const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const Box box = clipped_bounds(t, {{1, -1, -1}, {3, 9, 1}});
    CHECK((box.min == Vec3f(1, 0, 0)));
    CHECK((box.max == Vec3f(3, next_above(3), 0)));
}

TEST_CASE("where a triangle misses a box that its own box overlaps, its clipped bounds are empty") {
    const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    CHECK(clipped_bounds(t, {{2.5f, 2.5f, -1}, {4, 4, 1}}).is_empty());
    CHECK_FALSE(clipped_bounds(t, {{2, 2, -1}, {4, 4, 1}}).is_empty());  // the box touches it in one point
}
