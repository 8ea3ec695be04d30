#include "raylab/accelerator/item_buffer/picture_hull.h"

#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/number/dyadic.h"

using namespace raylab;
using namespace raylab::adversarial;

namespace {

// The transformed vertex, exactly.
Vec3<Dyadic> placed(const Vec3f& vertex, const Affine& m) {
    const auto v = convert<Dyadic>(vertex);
    return v.x * convert<Dyadic>(m.columns[0]) + v.y * convert<Dyadic>(m.columns[1]) +
           v.z * convert<Dyadic>(m.columns[2]) + convert<Dyadic>(m.translation);
}

}  // namespace

TEST_CASE(
    "a placed triangle's corners are no further off than its picture's hull says, where a translation cancels them") {
    const PictureView view(camera_frame(Camera{}, {8, 8}));
    const auto judge = [&](Draw& draw) -> std::optional<std::string> {
        const auto far = [&] { return draw.in_cube(1) + Vec3f(1e7f, 0, 0); };
        const Triangle triangle{far(), far(), far()};
        Affine placement;
        for (Vec3f& column : placement.columns) column = draw.in_cube(1);
        placement.translation = convert<float>(-convert<double>(placement.columns[0]) * 1e7);
        const Shape shape = triangle;
        const PictureHull hull = picture_hull(view, {&shape, 0, &placement, Sides::both}, bounds(triangle, placement));
        if (hull.count != 3) return "not three corners";
        const std::array vertices{triangle.a, triangle.b, triangle.c};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto way = placed(vertices[i], placement) - convert<Dyadic>(hull.corners[i]);
            const Dyadic off(hull.off);
            if (sign(dot(way, way) - off * off) == Sign::positive) return "a corner is farther off";
        }
        return std::nullopt;
    };
    CHECK(faults(1'000, judge) == "");
}
