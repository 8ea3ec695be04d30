#include "raylab/accelerator/bvh8/bvh8_walls.h"

#include "catch.h"
#include "raylab/accelerator/bvh8/bvh8_build.h"
#include "raylab/experiment/generate/architecture.h"

#include <algorithm>
#include <vector>

using namespace raylab;
using namespace raylab::bvh8_parts;

namespace {

std::vector<Triangle> quad(const Vec3f& at, const Vec3f& u, const Vec3f& v) {
    return {{at, at + u, at + u + v}, {at, at + u + v, at + v}};
}

// Two of the six faces of a box from (0, 0, 0) to `size`: those across an axis.
std::vector<Triangle> faces_across(int axis, const Vec3f& size) {
    Vec3f u{0, 0, 0}, v{0, 0, 0}, far{0, 0, 0};
    u[(axis + 1) % 3] = size[(axis + 1) % 3];
    v[(axis + 2) % 3] = size[(axis + 2) % 3];
    far[axis] = size[axis];
    auto both = quad({0, 0, 0}, u, v);
    for (const Triangle& one : quad(far, u, v)) both.push_back(one);
    return both;
}

Reference reference(const Triangle& t) {
    const auto min = [](float a, float b, float c) { return std::min({a, b, c}); };
    const auto max = [](float a, float b, float c) { return std::max({a, b, c}); };
    return {FourFloats{min(t.a.x, t.b.x, t.c.x), min(t.a.y, t.b.y, t.c.y), min(t.a.z, t.b.z, t.c.z), 0},
            FourFloats{max(t.a.x, t.b.x, t.c.x), max(t.a.y, t.b.y, t.c.y), max(t.a.z, t.b.z, t.c.z), 0}, 0,
            Kind::triangle};
}

bool is_room(const std::vector<Triangle>& triangles, const Vec3f& size) {
    Walls walls({FourFloats{0, 0, 0, 0}, FourFloats{size.x, size.y, size.z, 0}});
    for (const Triangle& one : triangles)
        if (walls.may_have(reference(one)) && walls.has(reference(one), one)) walls.add(one);
    return walls.make_a_room(triangles.size() + 1);
}

std::vector<Triangle> triangles_of(const Mesh& mesh) {
    std::vector<Triangle> triangles;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) triangles.push_back(mesh.triangle(face));
    return triangles;
}

// The triangles in leaves of the root.
std::vector<std::uint32_t> at_root(const Bvh8Nodes& tree) {
    std::vector<std::uint32_t> numbers;
    for (const Bvh8Child child : tree.nodes[0].children)
        if (child.kind() == Bvh8Child::Kind::triangles)
            for (std::size_t place = 0; place < child.count(); ++place) numbers.push_back(tree.number(child, place));
    std::ranges::sort(numbers);
    return numbers;
}

}  // namespace

TEST_CASE("a scene is a room where large triangles are half of its box's faces") {
    const Vec3f size{3, 3, 4};
    auto some = faces_across(0, size);  // 24 of 66
    CHECK_FALSE(is_room(some, size));
    for (const Triangle& one : faces_across(2, size)) some.push_back(one);  // 42
    CHECK(is_room(some, size));
    for (Triangle& one : some) std::swap(one.a, one.b);  // it does not matter which side is the front
    CHECK(is_room(some, size));
    some.pop_back();  // 37.5
    CHECK(is_room(some, size));
}

TEST_CASE("triangles that are small, or lie across no axis, are no walls") {
    const Vec3f size{2, 2, 2};
    std::vector<Triangle> pieces, sloping;
    for (int axis = 0; axis < 3; ++axis)
        for (const auto& [a, b, c] : faces_across(axis, size)) {
            const Vec3f ab = (a + b) / 2.0f, bc = (b + c) / 2.0f, ca = (c + a) / 2.0f;
            for (const Triangle& one : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
                pieces.push_back(one);
        }
    CHECK_FALSE(is_room(pieces, size));
    for (int i = 0; i < 4; ++i)
        for (const Triangle& one : quad({0, 0, 0}, {2, 0, 2}, {0, 2, 0})) sloping.push_back(one);
    CHECK_FALSE(is_room(sloping, size));
}

TEST_CASE("many sheets in a pile are no room: a ray would meet them all at the root") {
    const Vec3f size{1, 1, 1};
    std::vector<Triangle> pile;
    for (int i = 0; i < 33; ++i)
        for (const Triangle& one : quad({0, 0, 0.03f * cast<float>(i)}, {1, 0, 0}, {0, 1, 0})) pile.push_back(one);
    CHECK_FALSE(is_room(pile, size));
    pile.resize(64);
    CHECK(is_room(pile, size));
}

TEST_CASE("the walls of a hall lie at the root of bvh8, each rectangle in a leaf of its own; a city has none") {
    const auto hall = triangles_of(arcade_hall(3));
    for (const double duplicates : {0.0, 0.3}) {
        const Bvh8Nodes tree = build_bvh8_nodes(hall, {}, {.max_duplicates = duplicates});
        // Its sides, its ceiling and its floor are made first, but for its ends, which are small.
        CHECK(at_root(tree) == std::vector<std::uint32_t>{0, 1, 2, 3, 8, 9, 10, 11});
        for (const Bvh8Child child : tree.nodes[0].children)
            if (child.kind() == Bvh8Child::Kind::triangles) CHECK(child.count() == 2);
    }
    CHECK(at_root(build_bvh8_nodes(triangles_of(city(2)), {})).empty());
}

TEST_CASE("where all triangles are walls, or so small or large that areas are nothing or infinite, none is lost") {
    std::vector<Triangle> box;
    for (int axis = 0; axis < 3; ++axis)
        for (const Triangle& one : faces_across(axis, {1, 1, 1})) box.push_back(one);
    CHECK(at_root(build_bvh8_nodes(box, {})).size() == 12);
    for (const float by : {0x1p-80f, 0x1p66f}) {
        for (const std::size_t others : {1, 2, 9}) {
            const std::vector<Box> boxes(others, Box{Vec3f(0), Vec3f(by)});
            CHECK(build_bvh8_nodes({}, boxes).others.size() == others);
        }
        std::vector<Triangle> scaled = box;
        for (Triangle& t : scaled) t = {t.a * by, t.b * by, t.c * by};
        for (const std::size_t count : {12, 9, 8, 2, 1}) {
            scaled.resize(count);
            CHECK(at_root(build_bvh8_nodes(scaled, {})).size() == count);
        }
    }
}
