#include "raylab/geometry/bounds/box.h"

#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/number/dyadic.h"

#include <cmath>
#include <vector>

using namespace raylab;
using namespace raylab::adversarial;
using raylab::adversarial::Draw;

namespace {

Vec3<Dyadic> placed(const Vec3f& vertex, const Affine& m) {
    const auto v = convert<Dyadic>(vertex);
    return v.x * convert<Dyadic>(m.columns[0]) + v.y * convert<Dyadic>(m.columns[1]) +
           v.z * convert<Dyadic>(m.columns[2]) + convert<Dyadic>(m.translation);
}

bool holds(const Box& box, const Vec3<Dyadic>& p) {
    const auto between = [](float low, const Dyadic& x, float high) {
        return sign(x - Dyadic(low)) != Sign::negative && sign(Dyadic(high) - x) != Sign::negative;
    };
    return between(box.min.x, p.x, box.max.x) && between(box.min.y, p.y, box.max.y) &&
           between(box.min.z, p.z, box.max.z);
}

}  // namespace

TEST_CASE("the box about a placed triangle and about a placed mesh holds each corner where it is exactly") {
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        const Triangle triangle{draw.in_cube(1), draw.in_cube(1), draw.in_cube(1)};
        Affine placement;
        for (Vec3f& column : placement.columns) column = draw.in_cube(1);
        placement.translation = draw.in_cube(draw.one_in(2) ? 1 : 1e6);
        const auto mesh = std::make_shared<const Mesh>(Mesh{{triangle.a, triangle.b, triangle.c}, {{0, 1, 2}}});
        for (const Box& box : {bounds(triangle, placement), *bounds(Shape(mesh), placement)})
            for (const Vec3f& corner : {triangle.a, triangle.b, triangle.c})
                if (!holds(box, placed(corner, placement))) return "a corner is outside";
        return std::nullopt;
    };
    CHECK(faults(5'000, judge) == "");
}

TEST_CASE("the box about what overflows floats when it is placed is endless, not empty") {
    Affine far;
    far.columns = {Vec3f{0x1p127f, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}};
    const Box box = bounds(Triangle{{-4, 0, 0}, {4, 0, 0}, {0, 1, 0}}, far);
    CHECK(box.min.x == -std::numeric_limits<float>::infinity());
    CHECK(box.max.x == std::numeric_limits<float>::infinity());
    CHECK((box.max.y >= 1 && box.max.y < 1.0001f));
}

TEST_CASE("the box about what ends at 0 has no subnormal numbers") {
    const Polygon ground{{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}};
    for (const Shape& shape : std::vector<Shape>{ground, Cone{{0, 0, 0}, {0, 1, 0}, 1, 0},
                                                 Cylinder{{0, 0, 0}, {0, 0, 2}, 1}, Sphere{{1, 1, 1}, 1}}) {
        const Box box = *bounds(shape, Affine{});
        for (const Vec3f& corner : {box.min, box.max})
            for (int axis = 0; axis < 3; ++axis) CHECK(std::fpclassify(corner[axis]) != FP_SUBNORMAL);
        CHECK((box.min.y <= 0 && box.min.y > -2));
    }
}
