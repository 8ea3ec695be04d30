#include "raylab/accelerator/bvh8/triangle_runs.h"

#include "catch.h"
#include "raylab/experiment/generate/generate.h"

using namespace raylab;

TEST_CASE("triangles are numbered in the order in which they are added, from small meshes, large ones, and alone") {
    const Mesh small = bumpy_sphere(0), large = bumpy_sphere(5);
    const Triangle alone{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}};
    std::vector<std::pair<Triangle, Sides>> expected;
    TriangleRuns runs;
    const auto add = [&](const Mesh& mesh, Sides sides) {
        runs.add(mesh, sides);
        for (std::size_t face = 0; face < mesh.faces.size(); ++face) expected.emplace_back(mesh.triangle(face), sides);
    };
    add(large, Sides::both);
    add(small, Sides::both);
    for (const Sides sides : {Sides::both, Sides::front, Sides::front}) {
        runs.add(alone, sides);
        expected.emplace_back(alone, sides);
    }
    add(large, Sides::front);
    add(large, Sides::both);
    add(small, Sides::front);
    REQUIRE(runs.size() == expected.size());
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const Triangle found = runs[i];
        const auto& [triangle, sides] = expected[i];
        wrong += found.a != triangle.a || found.b != triangle.b || found.c != triangle.c || runs.sides(i) != sides;
    }
    CHECK(wrong == 0);
}
