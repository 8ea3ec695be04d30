#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/accelerator.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"

#include <array>
#include <memory>

// Rays exactly through the border of a flat mesh: three slabs of its box, or several planes between cells, are crossed
// at the same t, so that any rounding error shows. All numbers have few bits, so that the rays are exact.

using namespace raylab;
using namespace raylab::adversarial;

namespace {

constexpr int cells = 5;

// Two triangles for each cell in a plane perpendicular to an axis; the cells' sides are odd numbers.
struct Floor {
    Vec3f corner, right, up;

    Vec3f vertex(int i, int j) const { return corner + right * cast<float>(i) + up * cast<float>(j); }
    std::vector<Triangle> triangles() const {
        std::vector<Triangle> all;
        for (int i = 0; i < cells; ++i)
            for (int j = 0; j < cells; ++j) {
                const Vec3f a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i, j + 1), d = vertex(i + 1, j + 1);
                all.push_back({a, b, d});
                all.push_back({a, d, c});
            }
        return all;
    }
    Vec3f on_border(Draw& draw) const {
        const int along = draw.integer(0, cells), side = draw.one_in(2) ? 0 : cells;
        return draw.one_in(2) ? vertex(along, side) : vertex(side, along);
    }
};

Floor any_floor(Draw& draw, int axis) {
    const auto odd = [&] { return cast<float>(2 * draw.integer(1, 300) + 1); };
    Floor floor{draw.on_lattice(-1000, 1000), Vec3f(0), Vec3f(0)};
    if (draw.one_in(2)) floor.corner[draw.integer(0, 2)] = 0;
    floor.right[(axis + 1) % 3] = odd();
    floor.up[(axis + 2) % 3] = odd();
    return floor;
}

// The orders of magnitude of coordinates and directions: t has that of their quotient, down to the smallest floats.
struct Scale {
    float unit, speed;
};
constexpr std::array scales{Scale{1, 1}, Scale{0x1p-40f, 0x1p-40f}, Scale{0x1p10f, 1}, Scale{0x1p-110f, 0x1p30f}};

// The ray hits the plane only in that point, an integer multiple of its direction's length away.
Ray to_border(Draw& draw, const Floor& floor, int axis, const Scale& scale) {
    Vec3f direction = draw.on_lattice(-300, 300);
    if (draw.one_in(3))
        direction = Vec3f(0);  // along the axis
    else if (draw.one_in(4))
        direction[(axis + 1) % 3] = 0;
    if (direction[axis] == 0) direction[axis] = draw.one_in(2) ? 1 : -7;
    const Vec3f target = floor.on_border(draw);
    return {(target - direction * cast<float>(draw.integer(1, 15))) * scale.unit, direction * scale.speed};
}

Scene scaled_scene(const Floor& floor, float unit) {
    std::vector<Triangle> triangles = floor.triangles();
    for (Triangle& t : triangles) t = {t.a * unit, t.b * unit, t.c * unit};
    return scene_of(triangles);
}

// Describes what is wrong with a structure's answers to some rays through borders.
std::string faults_at_borders(const std::string& name, int rays) {
    Draw draw(17);
    for (const Scale& scale : scales)
        for (int axis = 0; axis < 3; ++axis)
            for (int plane = 0; plane < 2; ++plane) {
                const Floor floor = any_floor(draw, axis);
                const Scene scene = scaled_scene(floor, scale.unit);
                const auto list = make_accelerator("list", scene), structure = make_accelerator(name, scene);
                Traversal traversal;
                for (int i = 0; i < rays; ++i) {
                    const Ray ray = to_border(draw, floor, axis, scale);
                    const auto expected = list->closest(ray, traversal), given = structure->closest(ray, traversal);
                    if (!expected) return "the ray misses the border: " + words(ray);
                    if (!same(given, expected)) return "another answer than the list's: " + words(ray);
                    if (!structure->occluded(ray, traversal)) return "occluded() denies closest(): " + words(ray);
                }
            }
    return "";
}

}  // namespace

TEST_CASE("a ray exactly through a vertex on the border of a flat mesh hits it, whatever finds the hit") {
    for (const std::string& name : accelerator_names()) {
        INFO(name);
        CHECK(faults_at_borders(name, 10) == "");
    }
    CHECK(faults_at_borders("bvh8", 200) == "");  // in floats rounding affects the borders more often
}

TEST_CASE("a ray along an axis where coordinates are 0 hits what begins or ends there, whatever finds the hit") {
    // Right triangles with their legs in two planes through the origin, all in one quadrant.
    for (int axis = 0; axis < 3; ++axis)
        for (const auto& [right_leg, up_leg] : {std::pair{1.0f, 1.0f}, {1.0f, -1.0f}, {-1.0f, 1.0f}, {-1.0f, -1.0f}}) {
            std::vector<Triangle> triangles;
            for (int k = 1; k <= 20; ++k) {
                Vec3f at(0), right(0), up(0);
                at[axis] = cast<float>(3 * k), right[(axis + 1) % 3] = right_leg, up[(axis + 2) % 3] = up_leg;
                triangles.push_back({at, at + right, at + up});
            }
            const Scene scene = scene_of(triangles);
            for (const std::string& name : accelerator_names()) {
                const auto structure = make_accelerator(name, scene);
                for (const auto& [zero, sense] :
                     {std::pair{0.0f, 1.0f}, {0.0f, -1.0f}, {-0.0f, 1.0f}, {-0.0f, -1.0f}}) {
                    Vec3f origin(zero), direction(zero);
                    origin[axis] = sense > 0 ? -1.0f : 100.0f, direction[axis] = sense;
                    Traversal traversal;
                    const auto hit = structure->closest({origin, direction}, traversal);
                    INFO(name << ", axis " << axis << ", along " << sense << ", legs " << right_leg << " " << up_leg
                              << ", zero " << zero);
                    REQUIRE(hit);
                    CHECK(hit->primitive.part == (sense > 0 ? 0 : 19));
                    CHECK(structure->occluded({origin, direction, {0, 45}}, traversal));
                }
            }
        }
}
