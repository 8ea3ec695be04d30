#include "raylab/accelerator/octree/octree.h"

#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"

#include <algorithm>
#include <cmath>

using namespace raylab;
using namespace raylab::adversarial;

namespace {

// The lattice's cells are 2^-12 wide and the planes between them multiples of that, because two markers determine the
// scene's box.
constexpr float cell = 0x1p-12f;

Triangle marker(float at) { return {Vec3f(at), Vec3f(at), Vec3f(at)}; }
std::vector<Triangle> markers() { return {marker(cell), marker(16 - cell)}; }

Vec3f corner_of_cells(Draw& draw, int level) {  // of cells that are 16 / 2^level wide
    const auto plane = [&] { return std::ldexp(cast<float>(draw.integer(0, 1 << level)), 4 - level); };
    return {plane(), plane(), plane()};
}

// Triangles in planes between cells, with corners where cells touch, and small triangles anywhere.
Scene in_planes(Draw& draw) {
    std::vector<Triangle> triangles = markers();
    for (int i = 0; i < 40; ++i) {
        Triangle t{corner_of_cells(draw, 4), corner_of_cells(draw, 4), corner_of_cells(draw, 3)};
        const int axis = draw.integer(0, 2);
        t.b[axis] = t.c[axis] = t.a[axis];
        for (Vec3f* corner : {&t.a, &t.b, &t.c})
            for (int along = 0; along < 3; ++along) (*corner)[along] = std::clamp((*corner)[along], cell, 16 - cell);
        triangles.push_back(t);
    }
    for (const Triangle& t : soup(draw, 60, 4, Vec3f(8))) triangles.push_back(t);
    return scene_of(triangles);
}

// A ray along planes, through edges and corners of cells.
Ray through_corners(Draw& draw) {
    const Vec3f origin = corner_of_cells(draw, draw.integer(1, 12));
    return {origin, draw.lattice_direction(2), {draw.one_in(2) ? -100.0f : 0.0f, 100}};
}

// A ray from in or beside planes, which along some axes it hardly leaves, or never reaches.
Ray hardly_across(Draw& draw) {
    Vec3f origin = corner_of_cells(draw, draw.integer(1, 8)), direction;
    for (int axis = 0; axis < 3; ++axis) {
        if (draw.one_in(2)) origin[axis] += std::ldexp(draw.uniform(-1, 1), draw.integer(-40, -8));
        direction[axis] = std::ldexp(draw.uniform(-1, 1), draw.one_in(2) ? draw.integer(-130, 0) : draw.integer(-8, 0));
    }
    direction[draw.integer(0, 2)] = draw.one_in(2) ? 1.0f : -1.0f;
    return {origin, direction, {draw.one_in(2) ? -100.0f : 0.0f, 100}};
}

template <class Structure>
std::string faults_in_planes(const OctreeLimits& limits, Ray (*ray_of)(Draw&) = through_corners) {
    Draw scene_draw(3);
    const Scene scene = in_planes(scene_draw);
    const Structure octree(scene, limits);
    const auto list = make_accelerator("list", scene);
    return faults(10'000, [&](Draw& draw) -> std::optional<std::string> {
        const Ray ray = ray_of(draw);
        Traversal traversal;
        const auto expected = list->closest(ray, traversal), given = octree.closest(ray, traversal);
        const bool same =
            expected ? given && given->primitive == expected->primitive && given->t == expected->t : !given;
        return same && octree.occluded(ray, traversal) == expected.has_value() ? std::nullopt
                                                                               : std::optional(words(ray));
    });
}

constexpr OctreeLimits::Cut always = OctreeLimits::Cut::always;
constexpr OctreeLimits::Seads seads{.largest = 20, .bits = 3};

const Box& box_of(const Bound& bound) { return std::get<Box>(bound); }

}  // namespace

TEST_CASE("CELL-FACE: rays and triangles in planes between cells, through their edges and corners, are answered as the "
          "list does") {
    CHECK(faults_in_planes<Octree>({.few = 1, .depth = 8, .cut = always}) == "");
    CHECK(faults_in_planes<OctreePoint>({.few = 1, .depth = 8, .cut = always}) == "");
    CHECK(faults_in_planes<OctreeHash>({.few = 1, .depth = 8, .cut = always}) == "");
    CHECK(faults_in_planes<OctreeSeads>({.few = 1, .depth = 8, .cut = always}) == "");
    CHECK(faults_in_planes<OctreeSeads>({.few = 1, .cut = always, .seads = seads}) == "");
    CHECK(faults_in_planes<Octree>({.few = 1, .depth = 8, .cut = always, .assign = OctreeLimits::Assign::by_box}) ==
          "");
}

TEST_CASE("CELL-FACE: so are rays that hardly leave the planes they begin in, or never reach those beside them") {
    for (const int depth : {8, Lattice::bits}) {
        const OctreeLimits limits{.few = 1, .depth = depth, .cut = always};
        CHECK(faults_in_planes<Octree>(limits, hardly_across) == "");
        CHECK(faults_in_planes<OctreePoint>(limits, hardly_across) == "");
        CHECK(faults_in_planes<OctreeHash>(limits, hardly_across) == "");
        CHECK(faults_in_planes<OctreeSeads>(limits, hardly_across) == "");
    }
}

TEST_CASE("CELL-FACE: so are rays that cut off the edge of a cell by less than places in floats are rounded by") {
    // Specks lie a little behind one plane and before another, and rays go exactly through a corner of theirs: by
    // rounded numbers, the ray may reach the two planes the other way around, and pass the speck's cell by.
    constexpr float unit = cell * 0x1p-12f, middle = 8;  // places in the middle are rounded by up to 8 units
    std::vector<Triangle> triangles{marker(cell - middle), marker(middle - cell)};
    Draw scene_draw(14);
    for (int i = 0; i < 200; ++i) {
        Vec3f edge;
        for (int axis = 0; axis < 3; ++axis) edge[axis] = cell * cast<float>(scene_draw.integer(-200, 200));
        const auto beside = [&](int x, int y) {
            return edge + unit * Vec3f(cast<float>(x), -cast<float>(y), cast<float>(scene_draw.integer(-9, 9)));
        };
        triangles.push_back({beside(1, 2), beside(1, 1), beside(2, 1)});
    }
    const Scene scene = scene_of(triangles);
    const auto list = make_accelerator("list", scene);
    const OctreeLimits limits{.few = 0, .depth = Lattice::bits, .cut = always};
    const Octree by_times(scene, limits);
    const OctreePoint by_points(scene, limits);
    const auto judge = [&](Draw& draw) -> std::optional<std::string> {
        const auto number = static_cast<std::size_t>(draw.integer(2, static_cast<int>(triangles.size()) - 1));
        Vec3f direction;
        for (int axis = 0; axis < 3; ++axis) direction[axis] = unit * cast<float>(draw.integer(1, 1 << 14));
        const Ray ray{triangles[number].b - direction * cast<float>(draw.integer(1, 15)), direction};
        Traversal traversal;
        const bool is_hit = list->closest(ray, traversal).has_value();
        const bool same = by_times.closest(ray, traversal).has_value() == is_hit &&
                          by_points.closest(ray, traversal).has_value() == is_hit;
        return same && is_hit ? std::nullopt : std::optional(words(ray));
    };
    CHECK(faults(10'000, judge) == "");
}

TEST_CASE("a leaf is empty, has few primitives, or is small") {
    Draw draw(9);
    const Scene scene = scene_of(soup(draw, 400, 2));
    const Outline outline = Octree(scene, {.few = 3, .depth = 6, .cut = always}).outline();
    const auto width = [&](const Outline::Node& node) { return box_of(node.bound).max.x - box_of(node.bound).min.x; };
    const float smallest = width(outline.nodes[0]) / 64;
    std::size_t crowded = 0;
    for (const Outline::Node& node : outline.nodes) {
        if (!node.children.empty()) {
            CHECK(node.children.size() == 8);
            continue;
        }
        const bool small = width(node) < 1.5f * smallest;
        CHECK((node.primitives.size() <= 3 || small));
        crowded += node.primitives.size() > 3 ? 1 : 0;
    }
    CHECK(crowded > 0);
}

TEST_CASE("an octree takes no more references than its budget allows") {
    Draw draw(11);
    std::vector<Triangle> large;
    for (int i = 0; i < 500; ++i) large.push_back({draw.in_cube(1), draw.in_cube(1), draw.in_cube(1)});
    const Scene scene = scene_of(large);
    const auto references = [&](int budget) {
        std::size_t sum = 0;
        for (const auto& node : Octree(scene, {.budget = budget}).outline().nodes) sum += node.primitives.size();
        return sum;
    };
    CHECK(references(4) <= 4 * 500);
    CHECK(references(64) <= 64 * 500);
    CHECK(references(64) > references(4));
}

TEST_CASE("an octree of a few large shapes is no deeper than memory allows") {
    Draw draw(12);
    Scene scene;
    for (int i = 0; i < 11; ++i) scene.objects.push_back(object(Sphere{draw.in_cube(0.1), draw.uniform(0.5f, 1)}));
    const auto octree = make_accelerator("octree:16", scene);
    CHECK(octree->bytes() < std::size_t{1} << 26);
    CHECK(octree->bytes() > make_accelerator("octree:3", scene)->bytes());
}

TEST_CASE("a triangle is put only into cells that it touches, and into all of those") {
    const Scene scene = scene_of({{{0, 0, 0}, {8, 0, 0.01f}, {0, 8, 8}}, {{7, 7, 7}, {8, 8, 8}, {8, 7, 7}}});
    const auto references = [&](OctreeLimits::Assign assign) {
        std::size_t sum = 0;
        const Octree octree(scene, {.few = 0, .depth = 5, .cut = always, .assign = assign});
        for (const auto& node : octree.outline().nodes) sum += node.primitives.size();
        return sum;
    };
    CHECK(2 * references(OctreeLimits::Assign::by_shape) < references(OctreeLimits::Assign::by_box));
}

TEST_CASE("rays from so far away that no cell can be told are tested against everything") {
    Draw draw(13);
    const Scene scene = scene_of(soup(draw, 50, 1));
    const auto list = make_accelerator("list", scene);
    const Octree octree(scene);
    const auto judge = [&](Draw& far) -> std::optional<std::string> {
        const Ray ray{{far.uniform(-1, 1), far.uniform(-1, 1), std::ldexp(far.uniform(1, 2), far.integer(20, 60))},
                      {0, 0, -1}};
        Traversal traversal;
        const auto expected = list->closest(ray, traversal), given = octree.closest(ray, traversal);
        const bool same =
            expected ? given && given->primitive == expected->primitive && given->t == expected->t : !given;
        return same ? std::nullopt : std::optional(words(ray));
    };
    CHECK(faults(2'000, judge) == "");
}

TEST_CASE("such a ray is tested against each primitive once, in however many cells it is") {
    const Scene scene = scene_of({{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}}});
    const Octree octree(scene, {.few = 0, .depth = 6, .cut = always});
    const Ray past{{0x1p20f, 3, 0x1p60f}, {0, 0, -1}};
    Traversal traversal;
    CHECK_FALSE(octree.closest(past, traversal));
    CHECK(traversal.primitive_tests == 2);
    CHECK_FALSE(octree.occluded(past, traversal));
    CHECK(traversal.primitive_tests == 4);
}

TEST_CASE("specks on a slanted line are hit from however far away") {
    // Each small triangle contains a point of the line, through which the rays go exactly.
    const Vec3f along{1, 2, 3};
    for (int k = 1; k < 16; ++k) {
        const Vec3f speck = scaled(along, cast<float>(k) / 16);
        constexpr float size = 0x1p-12f;
        const Scene scene =
            scene_of({{Vec3f(0), Vec3f(0), Vec3f(0)},
                      {Vec3f(3), Vec3f(3), Vec3f(3)},
                      {speck + Vec3f(size, -size, 0), speck + Vec3f(0, size, -size), speck + Vec3f(-size, 0, size)}});
        const Octree octree(scene, {.few = 0, .cut = always});
        for (int exponent = 0; exponent <= 80; ++exponent)
            for (const float sense : {1.0f, -1.0f}) {
                const Ray ray{scaled(along, -sense * std::ldexp(1.0f, exponent)), scaled(along, sense)};
                Traversal traversal;
                INFO("from 2^" << exponent << " to " << k << "/16");
                CHECK(octree.closest(ray, traversal).has_value());
                CHECK(octree.occluded(ray, traversal));
            }
    }
}
