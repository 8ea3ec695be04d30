#include "catch.h"

#include "raylab/experiment/generate/generate.h"
#include "raylab/geometry/mesh/vertex_normals.h"
#include "raylab/sampling/sequence.h"

#include <cmath>

using namespace raylab;

namespace {

// The corner of a cube at the origin; each face is fanned or not, so that a vertex has from one to two triangles of it.
Mesh cube_corner() {
    return {.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}},
            .faces = {{0, 2, 1}, {0, 3, 2}, {0, 4, 5}, {0, 5, 3}, {0, 1, 4}, {1, 6, 4}}};
}

double distance(const Vec3f& a, const Vec3d& b) { return glm::length(convert<double>(a) - b); }

}  // namespace

TEST_CASE("the normal of a cube's corner does not depend on how its faces are cut into triangles") {
    const auto normals = vertex_normals(cube_corner());
    CHECK(distance(normals.at(0), Vec3d{-1, -1, -1} / std::sqrt(3.0)) < 1e-7);
}

TEST_CASE("the vertex normals of a fine sphere are those of the sphere") {
    const Mesh mesh = icosphere(4);
    const auto normals = vertex_normals(mesh);
    for (std::size_t i = 0; i < normals.size(); ++i)
        CHECK(distance(normals[i], convert<double>(mesh.vertices[i])) < 3e-3);
}

TEST_CASE("a triangle without area takes no normal from its neighbours") {
    const Mesh mesh{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .faces = {{0, 1, 2}, {0, 1, 0}, {1, 2, 2}}};
    for (const auto& normal : vertex_normals(mesh)) CHECK(normal == Vec3f{0, 0, 1});
}

TEST_CASE("a vertex of no triangle with area, and one whose triangles cancel, has no normal") {
    const Mesh mesh{.vertices = {{0, 0, 0}, {0.3f, 0.1f, 0.7f}, {0.2f, 0.9f, 0.1f}, {5, 5, 5}, {6, 6, 6}},
                    .faces = {{0, 1, 2}, {1, 0, 2}, {3, 4, 3}}};
    for (const auto& normal : vertex_normals(mesh)) CHECK(normal == Vec3f{0, 0, 0});
}

TEST_CASE("normals that cancel but for their rounding leave none behind") {
    RandomSequence random(1, 0);
    for (int i = 0; i < 100; ++i) {
        // Their sizes differ so much that the differences of their coordinates are rounded.
        const auto somewhere = [&](double size) { return convert<float>(random.in_cube() * size); };
        const Mesh leaf{.vertices = {somewhere(1), somewhere(1e-2), somewhere(1e-4)},
                        .faces = {{0, 1, 2}, {0, 2, 1}}};  // the third order would cancel to the last bit
        for (const auto& normal : vertex_normals(leaf)) CHECK(normal == Vec3f{0, 0, 0});
    }
}

TEST_CASE("the size of a mesh says nothing about its normals") {
    const Mesh mesh = icosphere(1);
    for (const float size : {1e-38f, 1e37f}) {
        Mesh scaled = mesh;
        for (auto& vertex : scaled.vertices) vertex *= size;
        const auto normals = vertex_normals(scaled);
        for (std::size_t i = 0; i < normals.size(); ++i)
            CHECK(distance(normals[i], convert<double>(mesh.vertices[i])) < 1e-4);
    }
}
