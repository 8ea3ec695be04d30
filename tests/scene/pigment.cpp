#include "catch.h"

#include "raylab/scene/pigment.h"

using namespace raylab;

namespace {

const Color light{0.9, 0.9, 0.9}, dark{0.1, 0.1, 0.1};
const Pigment checker = Checker{light, dark, 0.5};

}  // namespace

TEST_CASE("a plain pigment is the same everywhere") {
    CHECK(color_at(Color{0.1, 0.2, 0.3}, {5, 6, 7}, {0, 1, 0}) == Color{0.1, 0.2, 0.3});
}

TEST_CASE("checker cells alternate along both directions of a floor, across the origin too") {
    const Vec3d up{0, 1, 0};
    CHECK(color_at(checker, {0.25, 0, 0.25}, up) == light);
    CHECK(color_at(checker, {0.75, 0, 0.25}, up) == dark);
    CHECK(color_at(checker, {-0.25, 0, 0.25}, up) == dark);
    CHECK(color_at(checker, {-0.25, 0, -0.25}, up) == light);
    CHECK(color_at(checker, {0.75, 0, 0.75}, up) == light);
}

TEST_CASE("a floor's height, rounded to either side of a cell's edge, does not speckle its checker") {
    for (const double height : {-1e-12, 0.0, 1e-12}) {
        CHECK(color_at(checker, {0.25, height, 0.25}, {0, 1, 0}) == light);
        CHECK(color_at(checker, {0.25, 0.25, 0.5 + height}, {0, 0, -1}) == light);
    }
}
