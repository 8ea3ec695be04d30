#include "raylab/accelerator/grid/grid.h"

#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/grid/grid_walk.h"
#include "raylab/base/error.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/experiment/generate/generate.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace raylab;
using namespace raylab::adversarial;

namespace {

std::set<std::size_t> cells_walked(const GridPlanes& planes, const Ray& ray) {
    GridWalk walk(planes, ray);
    std::set<std::size_t> cells;
    for (bool inside = walk.is_sure() && walk.enters(); inside; inside = walk.next()) cells.insert(walk.index());
    return cells;
}

bool lists(const GridPlanes& planes, std::size_t index, const Box& box) {
    const auto range = planes.reached(box);
    const Cell cell = planes.cell(index);
    return std::ranges::all_of(std::array{0u, 1u, 2u},
                               [&](std::size_t a) { return range.first[a] <= cell[a] && cell[a] <= range.last[a]; });
}

// Points on a lattice of 2^-10, as boxes; every fourth is at an even fraction of the cube.
std::vector<Box> points(Draw& draw, std::size_t count) {
    std::vector<Box> boxes{{Vec3f(0), Vec3f(0)}, {Vec3f(1), Vec3f(1)}};
    while (boxes.size() < count) {
        const Vec3f p =
            boxes.size() % 4 == 0 ? scaled(draw.on_lattice(0, 8), 0x1p-3f) : scaled(draw.on_lattice(0, 1024), 0x1p-10f);
        boxes.push_back({p, p});
    }
    return boxes;
}

Scene mesh_scene(const Mesh& mesh) { return {.objects = {object(std::make_shared<const Mesh>(mesh))}}; }

Ray towards_middle(Draw& draw, float from) {
    const Vec3f origin = scaled(draw.in_cube(1), from);
    return {origin, -origin + draw.in_cube(1)};
}

}  // namespace

TEST_CASE("at the t of a hit the walk stands in a cell that has what is hit") {
    Draw scene_draw(3);
    const auto boxes = points(scene_draw, 500);
    for (const double density : {0.5, 8.0, 100.0}) {
        const GridPlanes planes = grid_planes(boxes, density);
        const auto judge = [&](Draw& draw) -> std::optional<std::string> {
            const Box& box = boxes[static_cast<std::size_t>(draw.integer(0, 499))];
            // The ray is at the point at t, exactly, because all of these are short binary numbers.
            const float t = std::ldexp(1.0f, draw.integer(-4, 8));
            const Vec3f direction = draw.lattice_direction(draw.one_in(2) ? 3 : 1) * (draw.one_in(2) ? 1.0f : 0x1p-10f);
            Ray ray{box.min - direction * t, direction, {t, t}};
            if (draw.one_in(2)) ray = {box.min + direction * t, -direction, {t, t}};
            const auto cells = cells_walked(planes, ray);
            const bool hit_found =
                std::ranges::any_of(cells, [&](std::size_t index) { return lists(planes, index, box); });
            return hit_found ? std::nullopt : std::optional(words(ray));
        };
        CHECK(faults(20'000, judge) == "");
    }
}

TEST_CASE("specks on a diagonal are hit from however far away") {
    // Each small triangle contains a point of the diagonal, through which the rays go exactly.
    for (int k = 1; k < 16; ++k) {
        const Vec3f speck = Vec3f(cast<float>(k) / 16);
        std::vector<Triangle> triangles;
        for (const float x : {0.0f, 1.0f})  // these make the box that is divided into cells, and are off the diagonal
            triangles.push_back({{x, 1 - x, 0}, {x, 1 - x, 1}, {x, 1 - x, 0.5f}});
        constexpr float size = 0x1p-12f;
        triangles.push_back(
            {speck + Vec3f(size, -size, 0), speck + Vec3f(0, size, -size), speck + Vec3f(-size, 0, size)});
        const Scene scene = scene_of(triangles);
        const Grid grid(scene, {.density = 3000});
        for (int exponent = 0; exponent <= 80; ++exponent)
            for (const float sense : {1.0f, -1.0f}) {
                const Ray ray{Vec3f(-sense * std::ldexp(1.0f, exponent)), Vec3f(sense)};
                Traversal traversal;
                INFO("from 2^" << exponent << " to " << k << "/16");
                CHECK(grid.closest(ray, traversal).has_value());
                CHECK(grid.occluded(ray, traversal));
            }
    }
}

TEST_CASE("a ray from further than doubles can follow is tested against everything") {
    const Scene scene = mesh_scene(icosphere(2));
    const Grid grid(scene);
    Traversal traversal;
    grid.closest({{1e20f, 0, 0}, {-1, 0, 0}}, traversal);
    CHECK(traversal.primitive_tests == 320);
    CHECK(traversal.steps == 0);
    grid.closest({{1e4f, 0, 0}, {-1, 0, 0}}, traversal);
    CHECK(traversal.steps > 0);
}

TEST_CASE("the walk ends in the cell of the first hit") {
    const Scene scene = mesh_scene(bumpy_sphere(4));
    const Grid grid(scene);
    const Ray through{{-3, 0.02f, 0.01f}, {1, 0, 0}};
    const auto visits = grid.visits(through);
    const auto cells_across = static_cast<std::size_t>(grid.planes().cells(0));
    CHECK(visits.size() < cells_across / 4);
    CHECK(visits.back().kind == Visit::Kind::leaf);
}

TEST_CASE("visits() tells of the cells and tests that closest() counts") {
    const Scene scene = mesh_scene(trefoil_knot(0.5, 4));
    const Grid grid(scene);
    const auto judge = [&](Draw& draw) -> std::optional<std::string> {
        const Ray ray = towards_middle(draw, 9);
        Traversal traversal;
        grid.closest(ray, traversal);
        std::uint64_t tests = 0;
        const auto visits = grid.visits(ray);
        for (const Visit& visit : visits) tests += visit.tests;
        const bool same = visits.size() == traversal.steps && tests == traversal.primitive_tests;
        return same ? std::nullopt : std::optional(words(ray));
    };
    CHECK(faults(500, judge) == "");
}

TEST_CASE("with mailboxes nothing is tested twice, with a small cache less often, and all answer alike") {
    const Scene scene = mesh_scene(trefoil_knot(0.5, 4));
    const Grid none(scene, {.density = 30}), ids(scene, {.density = 30, .mailboxes = MailboxKind::ray_id}),
        cache(scene, {.density = 30, .mailboxes = MailboxKind::small_cache});
    Traversal without, with, some;
    Draw draw(5);
    for (int i = 0; i < 500; ++i) {
        const Ray ray = towards_middle(draw, 9);
        const auto before = with.primitive_tests;
        const auto expected = none.closest(ray, without), by_id = ids.closest(ray, with),
                   by_cache = cache.closest(ray, some);
        INFO(words(ray));
        REQUIRE(by_id.has_value() == expected.has_value());
        REQUIRE(by_cache.has_value() == expected.has_value());
        if (expected) CHECK((by_id->primitive == expected->primitive && by_cache->primitive == expected->primitive));
        CHECK(with.primitive_tests - before <= 512);  // the number of primitives
    }
    CHECK(with.primitive_tests < some.primitive_tests);
    CHECK(some.primitive_tests < without.primitive_tests);
}

TEST_CASE("a mailbox is of one question: what was missed in one range may be hit in another") {
    const Scene scene = mesh_scene(icosphere(2));
    const Grid grid(scene, {.mailboxes = MailboxKind::ray_id});
    Traversal traversal;
    Ray ray{{-3, 0.1f, 0.2f}, {1, 0, 0}, {0, 1}};
    CHECK_FALSE(grid.occluded(ray, traversal));
    ray.range.max = 10;
    CHECK(grid.occluded(ray, traversal));
    CHECK(grid.closest(ray, traversal).has_value());
    CHECK(grid.occluded(ray, traversal));
}

TEST_CASE("there are about as many cells as the density says, cubes as nearly as may be") {
    for (const Vec3f sides : {Vec3f(1), Vec3f(1, 5, 0.3f), Vec3f(1, 1, 0), Vec3f(100, 1, 1e-3f)}) {
        std::vector<Box> boxes;
        for (int i = 0; i < 1000; ++i) {
            const Vec3f p = i % 2 == 0 ? Vec3f(0) : sides;
            boxes.push_back({p, p});
        }
        for (const double density : {0.1, 1.0, 10.0}) {
            const GridPlanes planes = grid_planes(boxes, density);
            const double share = static_cast<double>(planes.cell_count()) / (density * 1000);
            INFO(sides.x << " " << sides.y << " " << sides.z << ", density " << density << ": " << planes.cells(0)
                         << " " << planes.cells(1) << " " << planes.cells(2));
            CHECK(share <= 1);
            CHECK(share > 0.4);
        }
    }
}

TEST_CASE("a setting follows a structure's name, and is checked") {
    const Scene scene = mesh_scene(icosphere(3));
    CHECK(make_accelerator("grid:64", scene)->bytes() > make_accelerator("grid:1", scene)->bytes());
    CHECK(make_accelerator("grid_mailbox:8", scene)->bytes() == make_accelerator("grid", scene)->bytes());
    for (const std::string name : {"grid:", "grid:x", "grid:0", "grid:-1", "grid:nan", "grid:1e9", "grid:8 "})
        CHECK_THROWS_WITH(make_accelerator(name, scene),
                          "expected grid: and a number from 0.001 to 1000, found \"" + name + "\"");
    CHECK_THROWS_AS(make_accelerator("list:8", scene), Error);
}

TEST_CASE("memory stays bounded where everything reaches everywhere") {
    const std::vector<Box> boxes(100'000, Box{Vec3f(0), Vec3f(1)});
    CHECK(grid_planes(boxes, 8).cell_count() < 1000);
}

TEST_CASE("memory stays bounded however many cells a box are asked for") {
    Draw draw(21);
    std::vector<Box> boxes;
    for (int i = 0; i < 10'000; ++i) {
        const Vec3f corner = draw.in_cube(100);
        boxes.push_back({corner, corner + Vec3f(1e-3f)});
    }
    const std::size_t largest = (std::size_t{1} << 22) + 64 * boxes.size();
    CHECK(grid_planes(boxes, 1000).cell_count() <= largest);
    CHECK(grid_planes(boxes, 1000).cell_count() > largest / 2);
}
