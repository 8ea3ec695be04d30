#include "raylab/accelerator/grid/grid_planes.h"

#include "catch.h"

#include <cmath>
#include <limits>

using namespace raylab;

namespace {

// The planes of a unit cube with a thousand boxes in it.
GridPlanes planes_in_cube() {
    std::vector<Box> boxes{{Vec3f(0), Vec3f(1)}};
    boxes.resize(1000, {Vec3f(0.25f), Vec3f(0.5f)});
    return grid_planes(boxes, 1);
}

}  // namespace

TEST_CASE("a box that ends within the slack of a plane reaches into the cells on both its sides") {
    const GridPlanes planes = planes_in_cube();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis)
        for (int k = 1; k < planes.cells(axis); ++k) {
            const double plane = planes.along[static_cast<std::size_t>(axis)][static_cast<std::size_t>(k)];
            float below = cast<float>(plane), above = below;
            if (below >= plane) below = std::nextafter(below, -infinity);
            if (above <= plane) above = std::nextafter(above, infinity);
            REQUIRE(plane - below < planes.slack);
            REQUIRE(above - plane < planes.slack);
            Box ends_below{Vec3f(0.5f), Vec3f(0.5f)}, begins_above = ends_below;
            ends_below.min[axis] = 0, ends_below.max[axis] = below;
            begins_above.min[axis] = above, begins_above.max[axis] = 1;
            CHECK(planes.reached(ends_below).last[static_cast<std::size_t>(axis)] == k);
            CHECK(planes.reached(begins_above).first[static_cast<std::size_t>(axis)] == k - 1);
        }
}

TEST_CASE("a cell is grown by twice the slack before it is told what reaches into it") {
    const GridPlanes planes = planes_in_cube();
    for (std::size_t index = 0; index < planes.cell_count(); ++index) {
        const Cell cell = planes.cell(index);
        const BoxOfDoubles grown = planes.grown(cell);
        for (int axis = 0; axis < 3; ++axis) {
            const double* plane =
                planes.along[static_cast<std::size_t>(axis)].data() + cell[static_cast<std::size_t>(axis)];
            CHECK_THAT(plane[0] - (grown.center[axis] - grown.half[axis]), WithinRel(2 * planes.slack, 1e-6));
            CHECK_THAT(grown.center[axis] + grown.half[axis] - plane[1], WithinRel(2 * planes.slack, 1e-6));
        }
    }
}
