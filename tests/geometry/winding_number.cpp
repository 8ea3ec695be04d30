#include "catch.h"

#include "raylab/geometry/mesh/winding_number.h"

using namespace raylab;

namespace {

// The cube from -1 to 1, outward; its last two triangles are the top.
Mesh cube() {
    return {{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}},
            {{0, 2, 1},
             {0, 3, 2},
             {0, 1, 5},
             {0, 5, 4},
             {1, 2, 6},
             {1, 6, 5},
             {2, 3, 7},
             {2, 7, 6},
             {3, 0, 4},
             {3, 4, 7},
             {4, 5, 6},
             {4, 6, 7}}};
}

}  // namespace

TEST_CASE("a closed mesh winds once about a point inside and not at all about one outside") {
    for (const Vec3d inside : {Vec3d{0, 0, 0}, Vec3d{0.9, -0.9, 0.99}, Vec3d{0.5, 0.5, 0}})
        CHECK_THAT(winding_number(inside, cube(), {}), WithinAbs(1, 1e-12));
    for (const Vec3d outside : {Vec3d{2, 0, 0}, Vec3d{1.01, 1, 1}, Vec3d{0, 0, -3}})
        CHECK_THAT(winding_number(outside, cube(), {}), WithinAbs(0, 1e-12));
}

TEST_CASE("turned inside out a mesh winds the other way, and a mirroring transform turns it so") {
    Mesh turned = cube();
    for (auto& face : turned.faces) std::swap(face.a, face.b);
    CHECK_THAT(winding_number({0, 0, 0}, turned, {}), WithinAbs(-1, 1e-12));
    CHECK_THAT(winding_number({5, 0, 0}, cube(), {{Vec3f{-3, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}}, {4, 0, 0}}),
               WithinAbs(-1, 1e-12));
}

TEST_CASE("without its top a cube winds five sixths about its middle") {
    Mesh open = cube();
    open.faces.resize(10);
    CHECK_THAT(winding_number({0, 0, 0}, open, {}), WithinAbs(5.0 / 6, 1e-12));
}
