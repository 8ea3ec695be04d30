#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/accelerator.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"

// Triangles that lie in one plane across an axis, as a roof with its cornice: a ray hits them at the same t, and the
// first of them counts.

using namespace raylab;
using namespace raylab::adversarial;

namespace {

// Large and small ones over each other, in a plane or in two that floats hardly tell apart.
std::vector<Triangle> flush_triangles(Draw& draw) {
    const int axis = draw.integer(0, 2);
    const float at = draw.uniform(-4, 4), beside = std::nextafter(at, 10.0f);
    std::vector<Triangle> triangles;
    const int count = draw.integer(2, 40);
    for (int i = 0; i < count; ++i) {
        const Vec3f center = draw.in_cube(1);
        const double half = draw.one_in(3) ? 2 : 0.1;
        const float plane = draw.one_in(8) ? beside : at;
        const auto corner = [&] {
            Vec3f point = center + draw.in_cube(half);
            point[axis] = plane;
            return point;
        };
        triangles.push_back({corner(), corner(), corner()});
    }
    return triangles;
}

// Through a point of an edge, or of the inside; rounding carries it to either side of the edge.
Ray to(Draw& draw, const Triangle& triangle) {
    const auto [a, b, c] = triangle;
    const double v = draw.number(0, 1), w = draw.one_in(3) ? draw.number(0, 1 - v) : 0;
    const Vec3d point = convert<double>(a) + v * (convert<double>(b) - convert<double>(a)) +
                        w * (convert<double>(c) - convert<double>(a));
    return through(draw.in_cube(draw.one_in(2) ? 8 : 1000), point);
}

std::optional<std::string> compare(Draw& draw) {
    const std::vector<Triangle> triangles = flush_triangles(draw);
    const Scene scene = scene_of(triangles);
    const auto list = make_accelerator("list", scene);
    for (const char* name : {"bvh8", "bvh8_splits"}) {
        const auto tree = make_accelerator(name, scene);
        Traversal traversal;
        for (int i = 0; i < 40; ++i) {
            const auto aimed = static_cast<std::size_t>(draw.integer(0, static_cast<int>(triangles.size()) - 1));
            const Ray ray = to(draw, triangles[aimed]);
            if (!same(list->closest(ray, traversal), tree->closest(ray, traversal)))
                return std::string(name) + ": " + words(ray);
        }
    }
    return std::nullopt;
}

}  // namespace

TEST_CASE("bvh8 answers as the list does about triangles that lie in one plane") { CHECK(faults(3000, compare) == ""); }
