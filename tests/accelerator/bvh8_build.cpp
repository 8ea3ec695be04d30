#include "raylab/accelerator/bvh8/bvh8_build.h"
#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/bvh8/bvh8_plane_split.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/experiment/generate/uneven.h"

#include <cstring>

// The differential tester in tests/report checks that trees with split triangles answer as the list does, because
// "bvh8_splits" is a name of make_accelerator().

using namespace raylab;
using namespace raylab::adversarial;

namespace {

std::vector<Triangle> triangles_of(const Mesh& mesh) {
    std::vector<Triangle> triangles;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) triangles.push_back(mesh.triangle(face));
    return triangles;
}

template <class Some>
bool same_bits(const Some& a, const Some& b) {
    if (a.size() != b.size() || a.empty()) return a.size() == b.size();  // an empty vector may have no memory at all
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

bool same_tree(const Bvh8Nodes& a, const Bvh8Nodes& b) {
    return same_bits(a.nodes, b.nodes) && same_bits(a.leaves, b.leaves) && same_bits(a.others, b.others) &&
           a.triangle_count == b.triangle_count && a.farthest_origin == b.farthest_origin &&
           same_bits(a.center, b.center) && same_bits(a.half_size, b.half_size);
}

bool holds(const Bvh8Node& node, std::size_t place, const Vec3d& p) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto row = static_cast<std::size_t>(axis);
        if (!(p[axis] >= node.planes[row][place] && p[axis] <= node.planes[row + 3][place])) return false;
    }
    return true;
}

/// Whether a point of the triangle lies in every box on the way to one of the leaves that have it.
bool reaches(const Bvh8Nodes& tree, std::uint32_t triangle, const Vec3d& point, Bvh8Child from = Bvh8Child::node(0)) {
    if (!from.is_node()) {
        if (from.kind() != Bvh8Child::Kind::triangles) return false;
        for (std::size_t place = 0; place < from.count(); ++place)
            if (tree.number(from, place) == triangle) return true;
        return false;
    }
    const Bvh8Node& node = tree.nodes[from.first()];
    for (std::size_t place = 0; place < bvh8_width; ++place)
        if (holds(node, place, point) && reaches(tree, triangle, point, node.children[place])) return true;
    return false;
}

// Corners are multiples of 2^-20 and weights are sixteenths, so that points of the triangles are exact in doubles. Many
// triangles are long and thin, for which planes pay.
std::optional<std::string> lose_a_point(Draw& draw) {
    std::vector<Triangle> triangles;
    const auto number = [&](int most) { return std::ldexp(cast<float>(draw.integer(-most, most)), -20); };
    const auto point = [&](int most) { return Vec3f(number(most), number(most), number(most)); };
    const auto corner = [&] { return draw.one_in(3) ? draw.on_lattice(-4, 4) : point(1 << 22); };
    const float scale = draw.one_in(3) ? std::ldexp(1.0f, draw.integer(-100, 80)) : 1;
    for (int i = draw.integer(9, 120); i > 0; --i) {
        const Vec3f a = corner(), b = corner(), c = draw.one_in(4) ? corner() : b + point(1 << 12);
        triangles.push_back({a * scale, b * scale, c * scale});
    }
    const Bvh8Nodes tree = build_bvh8_nodes(triangles, {}, {.max_duplicates = 8});
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const auto& [a, b, c] = triangles[i];
        for (int v = draw.integer(0, 3); v <= 16; v += 3) {
            const int w = draw.integer(0, 16 - v);
            const Vec3d inside = (convert<double>(a) * (16.0 - v - w) + convert<double>(b) * double(v) +
                                  convert<double>(c) * double(w)) /
                                 16.0;
            if (!reaches(tree, i, inside)) return "a point of a triangle is in no leaf that has the triangle";
        }
    }
    return std::nullopt;
}

std::size_t named(const Bvh8Nodes& tree) {
    std::size_t count = 0;
    for (const Bvh8Node& node : tree.nodes)
        for (const Bvh8Child child : node.children)
            if (child.kind() == Bvh8Child::Kind::triangles) count += child.count();
    return count;
}

}  // namespace

namespace {

struct BuildInput {
    std::vector<Triangle> triangles;
    std::vector<Box> others;
};

BuildInput hair_and_boxes(Draw& draw) {
    BuildInput input{triangles_of(hair(7)), {}};
    for (const Triangle& one : soup(draw, 2'000, 3)) input.triangles.push_back(one);
    for (int i = 0; i < 20'000; ++i) {
        const Vec3f center = draw.in_cube(3);
        input.others.push_back({center - 0.01f, center + 0.01f});
    }
    return input;
}

// Eight children of the root, each too large for one thread: they are more than enough for two threads, and too few for
// five.
BuildInput eight_clusters(Draw& draw) {
    BuildInput input;
    for (int i = 0; i < 8; ++i) {
        const Vec3f corner(i & 1 ? 9.0f : -9.0f, i & 2 ? 9.0f : -9.0f, i & 4 ? 9.0f : -9.0f);
        for (const Triangle& one : soup(draw, 33'000, 1, corner)) input.triangles.push_back(one);
    }
    return input;
}

// The root splits the large half alone, again and again; the small one is flat, at 0 of either sign.
BuildInput small_and_large_half(Draw& draw, int count) {
    BuildInput input{soup(draw, count / 8, 0.01f), {}};
    for (Triangle& one : input.triangles)
        for (Vec3f* corner : {&one.a, &one.b, &one.c}) corner->x = draw.one_in(2) ? -0.0f : 0.0f;
    for (const Triangle& one : soup(draw, count - count / 8, 9, Vec3f(30, 0, 0))) input.triangles.push_back(one);
    return input;
}

}  // namespace

TEST_CASE("bvh8 is the same tree to the bit, however many threads build it", "[threads]") {
    Draw draw(5);
    // Triangles that share no vertices need more memory than the builder expects, which moves what threads write to.
    for (const auto& [triangles, others] :
         {hair_and_boxes(draw), BuildInput{soup(draw, 60'000, 3), {}}, eight_clusters(draw)})
        for (const double max_duplicates : {0.0, 0.5}) {
            const auto built = [&](int threads) {
                return build_bvh8_nodes(triangles, others, {.max_duplicates = max_duplicates, .threads = threads});
            };
            const Bvh8Nodes alone = built(1);
            REQUIRE(alone.nodes.size() > 1'500);
            for (const int threads : {2, 3, 4, 5, 0}) {
                INFO(triangles.size() << " triangles, " << threads << " threads, " << max_duplicates);
                CHECK(same_tree(built(threads), alone));
            }
        }
}

TEST_CASE("bvh8 is the same tree to the bit, of whatever size and in whatever pieces", "[threads]") {
    Draw draw(6);
    for (const int count : {9, 2'047, 4'097, 16'383, 16'385, 17'000, 17'001, 40'000, 131'071, 131'073}) {
        const auto [triangles, others] = small_and_large_half(draw, count);
        const Bvh8Nodes alone = build_bvh8_nodes(triangles, others, {.threads = 1});
        for (const int threads : {2, 3, 5}) {
            INFO(count << " triangles, " << threads << " threads");
            CHECK(same_tree(build_bvh8_nodes(triangles, others, {.threads = threads}), alone));
        }
    }
}

TEST_CASE("every point of a triangle that bvh8 splits is in a leaf that has the triangle, and in all boxes above it") {
    CHECK(faults(3'000, lose_a_point) == "");
}

TEST_CASE("bvh8 names no more duplicates than allowed, and uses them where triangles are long") {
    const auto triangles = triangles_of(hair(3));
    const std::size_t all = triangles.size();
    CHECK(named(build_bvh8_nodes(triangles, {})) == all);
    for (const double most : {0.1, 0.3}) {
        const std::size_t found = named(build_bvh8_nodes(triangles, {}, {.max_duplicates = most}));
        CHECK(static_cast<double>(found) <= (1 + most) * static_cast<double>(all));
        CHECK(static_cast<double>(found) >= (1 + most / 3) * static_cast<double>(all));
    }
}

TEST_CASE("triangles with corners that no box holds are not split, for their boxes are not the whole of them") {
    std::vector<Triangle> triangles = triangles_of(hair(1));
    CHECK(named(build_bvh8_nodes(triangles, {}, {.max_duplicates = 1})) > triangles.size());
    for (Triangle& t : triangles)
        for (Vec3f* corner : {&t.a, &t.b, &t.c}) *corner *= 0x1p61f;
    CHECK(named(build_bvh8_nodes(triangles, {}, {.max_duplicates = 1})) == triangles.size());
}

TEST_CASE("a primitive that a plane cuts lies in the two boxes together; a side without points of it is empty") {
    using namespace bvh8_parts;
    const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const Reference whole(four(t.a), FourFloats{4, 4, 0, 0}, 7, Kind::triangle);
    const auto [below, above] = cut_by_plane(whole, t, 0, 3);
    CHECK((below.min[0] == 0 && below.max[0] == 3 && below.max[1] == 4));
    CHECK((above.min[0] == 3 && above.max[0] == 4));
    CHECK_THAT(above.max[1], WithinAbs(1, 1e-6));
    CHECK(whole.in(above).number() == 7);
    const Reference corner = whole.in({FourFloats{2.5f, 2.5f, 0, 0}, FourFloats{4, 4, 0, 0}});
    CHECK(is_empty(cut_by_plane(corner, t, 0, 3).second));
    const auto [left, right] =
        cut_by_plane(Reference(four(t.a), FourFloats{4, 4, 0, 0}, 7, Kind::other), std::nullopt, 0, 3);
    CHECK((left.max[1] == 4 && right.max[1] == 4));  // of anything else the box is cut
}
