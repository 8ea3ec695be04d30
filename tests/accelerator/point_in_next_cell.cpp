#include "raylab/accelerator/octree/point_in_next_cell.h"

#include "catch.h"
#include "raylab/experiment/adversarial/adversarial.h"

using namespace raylab;

TEST_CASE("a ray goes on half the smallest cell beyond the face, beside the place where it leaves") {
    const OctreeCube cube{{4, 8, -4}, 4};
    CHECK(point_in_next_cell(cube, 1, {2, 9, -3}, {2, 0.5, 0}) == Vec3d(8.5, 10.5, -3));
    CHECK(point_in_next_cell(cube, 1, {5, 9, -3}, {-2, 0.5, 0}) == Vec3d(3.5, 9.25, -3));
    CHECK(point_in_next_cell(cube, 0.25, {5, 9, -3}, {0, 0, 1e-3}) == Vec3d(5, 9, 0.125));
}

TEST_CASE("rays out by an edge never go back and forth between cells") {
    adversarial::Draw draw(1);
    for (int i = 0; i < 2'000; ++i) {
        // From cell to cell of size 1, along rays that touch edges of cells except for rounding.
        Vec3d direction = convert<double>(draw.lattice_direction(3)) * draw.number(0.1, 10);
        const Vec3d origin = convert<double>(draw.on_lattice(-3, 3)) - draw.number(0, 5) * direction;
        Vec3d point = origin;
        for (int step = 0; step < 60; ++step) {
            const OctreeCube cube{{std::floor(point.x), std::floor(point.y), std::floor(point.z)}, 1};
            const Vec3d next = point_in_next_cell(cube, 1, origin, direction);
            bool backward = false;
            for (int axis = 0; axis < 3; ++axis)
                backward = backward || (std::floor(next[axis]) - cube.low[axis]) * direction[axis] < 0;
            INFO("direction " << direction.x << ", " << direction.y << ", " << direction.z << ", step " << step);
            REQUIRE_FALSE(backward);
            point = next;
        }
    }
}
