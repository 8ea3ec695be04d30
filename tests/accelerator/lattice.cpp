#include "raylab/accelerator/octree/lattice.h"

#include "catch.h"
#include "raylab/accelerator/octree/lattice_shape.h"

#include <limits>

using namespace raylab;

namespace {

// Cells have width 1, and the first one of the box is from 1 to 2, so that planes are at the integers.
const Box all{Vec3f(1), Vec3f(65535)};
constexpr float near_plane = Lattice::slack / 2;

}  // namespace

TEST_CASE("a box that ends within the slack of a plane touches the cells on both its sides") {
    const Lattice lattice(all);
    REQUIRE(lattice.width() == 1);
    for (int axis = 0; axis < 3; ++axis)
        for (const std::int32_t plane : {2, 300, 4096}) {
            const auto a = static_cast<std::size_t>(axis);
            Box ends_below{Vec3f(10), Vec3f(20)}, begins_above = ends_below;
            ends_below.min[axis] = 1, ends_below.max[axis] = cast<float>(plane) - near_plane;
            begins_above.min[axis] = cast<float>(plane) + near_plane, begins_above.max[axis] = 9000;
            CHECK(lattice.touched(ends_below).last[a] == plane);
            CHECK(lattice.touched(begins_above).first[a] == plane - 1);
        }
}

TEST_CASE("a triangle within the slack of a cube is not said to miss it, whichever way it lies") {
    const Lattice lattice(all);
    const LatticeCell cube{64, 64, 64};  // 8 cells along each side
    constexpr float far = 1000;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            // Triangles parallel to a face, or with an edge along one, as seen from the middle.
            const auto at = [&](float out, float u, float v) {
                Vec3f p(68);
                p[axis] += side * out, p[(axis + 1) % 3] += u, p[(axis + 2) % 3] += v;
                return p;
            };
            for (const auto& [gap, misses] : {std::pair{near_plane, false}, {1.0f, true}}) {
                INFO("axis " << axis << ", side " << side << ", gap " << gap);
                CHECK(LatticeTriangle(lattice, {at(4 + gap, -far, -far), at(4 + gap, far, -far), at(4 + gap, 0, far)})
                          .misses(cube, 3) == misses);
                CHECK(LatticeTriangle(lattice, {at(4 + gap, 0, -far), at(4 + gap, 0, far), at(far, 1, 0)})
                          .misses(cube, 3) == misses);
            }
        }
}
