#include "catch.h"
#include "raylab/accelerator/bvh8/bvh8_leaf_writer.h"

#include <bit>
#include <vector>

using namespace raylab;

namespace {

Sides sides_of(std::size_t place) { return place % 3 == 1 ? Sides::front : Sides::both; }

std::size_t append(LargeVector<Bvh8Line>& lines, const std::vector<Triangle>& triangles) {
    Bvh8LeafWriter writer;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) writer.add(triangles[i], 1000 + i, sides_of(i));
    return writer.append_to(lines);
}

void check_same_bits(const Vec3f& found, const Vec3f& expected) {
    for (int axis = 0; axis < 3; ++axis)
        CHECK(std::bit_cast<std::uint32_t>(found[axis]) == std::bit_cast<std::uint32_t>(expected[axis]));
}

void check_kept(const LargeVector<Bvh8Line>& lines, std::size_t first, const std::vector<Triangle>& triangles) {
    const Bvh8Vertices leaf(lines[first].floats.data());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        CHECK(leaf.number(i) == 1000 + i);
        CHECK(leaf.sides(i) == sides_of(i));
        const Triangle kept = leaf.triangle(i);
        check_same_bits(kept.a, triangles[i].a);
        check_same_bits(kept.b, triangles[i].b);
        check_same_bits(kept.c, triangles[i].c);
    }
}

// `fan` triangles about one point, followed by `loose` separate ones.
std::vector<Triangle> fan_and_loose(int fan, int loose) {
    std::vector<Triangle> triangles;
    const auto point = [](int i) { return Vec3f(static_cast<float>(i), static_cast<float>(i * i), 1); };
    for (int i = 0; i < fan; ++i) triangles.push_back({Vec3f(0), point(i + 1), point(i + 2)});
    for (int i = 20; i < 20 + 3 * loose; i += 3) triangles.push_back({point(i), point(i + 1), point(i + 2)});
    return triangles;
}

}  // namespace

TEST_CASE("a leaf keeps every bit of its triangles' corners, and their sides, however many vertices they share") {
    LargeVector<Bvh8Line> lines;
    std::vector<std::pair<std::size_t, std::vector<Triangle>>> leaves;
    for (int fan = 0; fan <= 8; ++fan)
        for (int loose = fan == 0 ? 1 : 0; fan + loose <= 8; ++loose) {
            leaves.emplace_back(0, fan_and_loose(fan, loose));
            leaves.back().first = append(lines, leaves.back().second);
            const std::size_t vertices = static_cast<std::size_t>((fan ? fan + 2 : 0) + 3 * loose);
            CHECK(Bvh8Vertices(lines[leaves.back().first].floats.data()).count() == std::max(vertices, bvh8_width));
        }
    for (const auto& [first, triangles] : leaves) check_kept(lines, first, triangles);
}

TEST_CASE("vertices of a leaf are the same only where all bits are: a zero has a sign") {
    LargeVector<Bvh8Line> lines;
    const std::vector<Triangle> triangles{{Vec3f(0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)},
                                          {Vec3f(-0.0f), Vec3f(1, -0.0f, 0), Vec3f(0, 1, -0.0f)}};
    check_kept(lines, append(lines, triangles), triangles);
}
