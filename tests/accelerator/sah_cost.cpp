#include "raylab/accelerator/split_tree/sah_cost.h"
#include "catch.h"

#include <cmath>
#include <limits>

using namespace raylab;

namespace {

SahCut cut_of(Vec3d size, int axis, double place, double below, double above) {
    return {size, axis, place, below, above, 1, 2, 0.25};
}

}  // namespace

TEST_CASE("a cube cut in halves: each is hit by two rays in three") {
    CHECK_THAT(sah_cost(cut_of({1, 1, 1}, 0, 0.5, 3, 6)), WithinRel(1 + 2 * (2.0 / 3 * 3 + 2.0 / 3 * 6), 1e-12));
}

TEST_CASE("a cut's cost does not depend on which axis is which, nor on the unit of length") {
    const double cost = sah_cost(cut_of({2, 3, 5}, 0, 0.5, 4, 7));
    CHECK_THAT(sah_cost(cut_of({5, 2, 3}, 1, 0.5, 4, 7)), WithinRel(cost, 1e-12));
    CHECK_THAT(sah_cost(cut_of({3, 5, 2}, 2, 0.5, 4, 7)), WithinRel(cost, 1e-12));
    CHECK_THAT(sah_cost(cut_of({2e30, 3e30, 5e30}, 0, 0.5e30, 4, 7)), WithinRel(cost, 1e-12));
}

TEST_CASE("a cut that leaves a side empty saves the bonus, of the tests only") {
    CHECK_THAT(sah_cost(cut_of({1, 1, 1}, 2, 0.5, 0, 6)), WithinRel(1 + 0.75 * 2 * (2.0 / 3 * 6), 1e-12));
    CHECK_THAT(sah_cost(cut_of({1, 1, 1}, 2, 0.5, 6, 0)), WithinRel(1 + 0.75 * 2 * (2.0 / 3 * 6), 1e-12));
}

TEST_CASE("a flat cell has an area, a line has none") {
    CHECK_THAT(sah_cost(cut_of({2, 0, 2}, 0, 1, 3, 3)), WithinRel(7.0, 1e-12));
    CHECK(sah_cost(cut_of({2, 0, 0}, 0, 1, 3, 3)) == std::numeric_limits<double>::infinity());
}
