#include "catch.h"
#include "radiosity/polygons.h"

#include "raylab/radiosity/form_factor/polygon_form_factor.h"
#include "raylab/radiosity/form_factor/rectangle_form_factor.h"

using namespace raylab;

namespace {

std::optional<double> factor(const PolygonPair& pair) { return rectangle_form_factor(pair.from, pair.to); }

Vertices random_rectangle(RandomSequence& random, int flat) {
    Vec3d corner = random.in_cube(), side[2];
    int sides = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == flat) continue;
        side[sides] = {0, 0, 0};
        side[sides++][axis] = random.between(0.1, 2);
    }
    return random.whole(0, 1) == 0 ? rectangle(corner, side[0], side[1]) : rectangle(corner, side[1], side[0]);
}

}  // namespace

TEST_CASE("rectangles in closed form: the catalogue's numbers") {
    CHECK_THAT(factor(parallel_pair(1, 1, 1)).value(), WithinRel(0.199824895698387, 1e-12));
    CHECK_THAT(factor(parallel_pair(1, 2, 1)).value(), WithinRel(0.285875384850715, 1e-12));
    CHECK_THAT(factor(parallel_pair(1, 1, 1, 1)).value(), WithinRel(0.0860504891523273, 1e-12));
    CHECK_THAT(factor(parallel_pair(1, 1, 1, 1, 1)).value(), WithinRel(0.0433274095741047, 1e-12));
    const Vertices larger = rectangle({0.5, -1, 0.75}, {0, 2, 0}, {2, 0, 0});
    CHECK_THAT(rectangle_form_factor(parallel_pair(1, 1, 1).from, larger).value(), WithinRel(0.334459184072937, 1e-12));
    CHECK_THAT(factor(hinged_pair(1, 1)).value(), WithinRel(0.200043776075403, 1e-12));
    CHECK_THAT(factor(hinged_pair(2, 1)).value(), WithinRel(0.232852602795362, 1e-12));
    CHECK_THAT(factor(hinged_pair(0.1, 0.1)).value(), WithinRel(0.281887806787901, 1e-12));
}

TEST_CASE("rectangles anywhere, parallel or perpendicular: as the double contour integral says") {
    int compared = 0;
    for (std::uint64_t i = 0; i < 300; ++i) {
        RandomSequence random(31, i);
        const Vertices a = random_rectangle(random, random.whole(0, 2)),
                       b = random_rectangle(random, random.whole(0, 2));
        const Placement place(random, 1, 3);
        const auto closed = rectangle_form_factor(place(a), place(b));
        if (!closed) continue;
        CHECK_THAT(*closed, WithinRel(polygon_form_factor(place(a), place(b)), 2e-12) || WithinAbs(0, 0));
        compared += *closed > 0;
    }
    CHECK(compared > 60);
}

TEST_CASE("no closed form is given where it would cancel, or for other polygons") {
    CHECK_FALSE(factor(parallel_pair(1e-3, 1e-3, 1, 1)));  // shifted, so that the sum would be taken
    CHECK(factor(parallel_pair(1e-3, 1e-3, 1)));           // opposite: another formula
    CHECK_FALSE(factor(hinged_pair(1, 1, 1)));
    CHECK_FALSE(rectangle_form_factor(Vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, parallel_pair(1, 1, 1).to));
    const Vertices trapezium{{0, 0, 1}, {0, 1, 1}, {0.5, 1, 1}, {1, 0, 1}};
    CHECK_FALSE(rectangle_form_factor(parallel_pair(1, 1, 1).from, trapezium));
    const Vertices turned_square{{0.5, 0, 1}, {0, 0.5, 1}, {0.5, 1, 1}, {1, 0.5, 1}};
    CHECK_FALSE(rectangle_form_factor(parallel_pair(1, 1, 1).from, turned_square));
}

TEST_CASE("rectangles that do not face each other exchange nothing") {
    const auto [floor, ceiling] = parallel_pair(1, 1, 1);
    CHECK(rectangle_form_factor(floor, turned(ceiling)) == 0.0);
    CHECK(rectangle_form_factor(turned(floor), ceiling) == 0.0);
    CHECK(rectangle_form_factor(floor, rectangle({2, 0, 0}, {1, 0, 0}, {0, 1, 0})) == 0.0);
    CHECK(rectangle_form_factor(floor, turned(hinged_pair(1, 1).to)) == 0.0);
}

TEST_CASE("perpendicular rectangles of which a part is behind the other: only the front counts") {
    const Vertices around = rectangle({-5, 0, 0}, {6, 0, 0}, {0, 1, 0});
    const Vertices sunk = rectangle({0, 0, -3}, {0, 1, 0}, {0, 0, 4});
    CHECK_THAT(6 * rectangle_form_factor(around, sunk).value(), WithinRel(0.200043776075403, 1e-12));
}
