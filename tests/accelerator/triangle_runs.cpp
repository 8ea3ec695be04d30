#include "raylab/accelerator/bvh8/triangle_runs.h"

#include "catch.h"
#include "raylab/experiment/generate/generate.h"

using namespace raylab;

TEST_CASE("triangles are numbered in the order in which they are added, from small meshes, large ones, and alone") {
    const Mesh small = bumpy_sphere(0), large = bumpy_sphere(5);
    const Triangle alone{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}};
    std::vector<Triangle> expected;
    TriangleRuns runs;
    const auto add = [&](const Mesh& mesh) {
        runs.add(mesh);
        for (std::size_t face = 0; face < mesh.faces.size(); ++face) expected.push_back(mesh.triangle(face));
    };
    add(large);
    add(small);
    runs.add(alone);
    expected.push_back(alone);
    add(large);
    add(large);
    add(small);
    REQUIRE(runs.size() == expected.size());
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const Triangle found = runs[i];
        wrong += found.a != expected[i].a || found.b != expected[i].b || found.c != expected[i].c;
    }
    CHECK(wrong == 0);
}
