#include "raylab/accelerator/bvh/ray_box.h"

#include "catch.h"
#include "geometry/verdict.h"

#include <gmpxx.h>

using namespace raylab;
using namespace raylab::adversarial;

namespace {

// The smallest t in range at which the ray is exactly inside.
std::optional<mpq_class> first_inside(const Ray& ray, const Box& box) {
    mpq_class near(ray.range.min), last(std::min(ray.range.max, std::numeric_limits<float>::max()));
    for (int axis = 0; axis < 3; ++axis) {
        const mpq_class o(ray.origin[axis]), d(ray.direction[axis]), low(box.min[axis]), high(box.max[axis]);
        if (d == 0) {
            if (o < low || o > high) return std::nullopt;
            continue;
        }
        const mpq_class one = (low - o) / d, other = (high - o) / d;
        near = std::max<mpq_class>(near, std::min(one, other));
        last = std::min<mpq_class>(last, std::max(one, other));
    }
    return near <= last ? std::optional(near) : std::nullopt;
}

BoxTree::Planes planes_of(const Box& box) {
    BoxTree::Node node;
    node.hold(0, box, 0, 0);
    node.hold(1, {}, 0, 0);
    return node.planes;
}

}  // namespace

TEST_CASE(
    "a ray is never said to miss a box that it exactly hits, nor to enter it later than it does, before or behind its "
    "origin") {
    // A ray exactly through a corner; only that point, or the box about it, is inside.
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        const auto number = [&](int largest) { return cast<float>(draw.integer(-largest, largest)); };
        const Vec3f corner{number(3000), number(3000), number(3000)}, direction = draw.lattice_direction(500);
        const float steps = number(30);
        Box box{corner, corner};
        for (int axis = 0; axis < 3; ++axis) {
            if (draw.one_in(2))
                box.max[axis] += cast<float>(draw.integer(0, 900));
            else
                box.min[axis] -= cast<float>(draw.integer(0, 900));
        }
        Ray ray{corner - direction * steps, direction, {-100, 100}};
        if (draw.one_in(4)) ray.range = {steps, steps};
        const auto truth = first_inside(ray, box);
        if (!truth) return "the ray misses its corner";
        const double entry = BoxRay(ray).entries(planes_of(box))[0];
        if (entry < std::numeric_limits<double>::infinity() && *truth >= entry) return std::nullopt;
        return fmt::format("enters at {} instead of {}: {}", entry, truth->get_d(), adversarial::words(ray));
    };
    CHECK(faults(20'000, judge) == "");
}
