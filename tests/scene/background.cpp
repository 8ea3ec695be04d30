#include "catch.h"

#include "raylab/scene/background.h"

using namespace raylab;

namespace {

constexpr Color low{0.8, 0.6, 0.4}, high{0, 0.2, 0.6};
const Background sky{.color = low, .zenith = high};

bool is_color(const Color& found, const Color& expected) { return glm::length(found - expected) < 1e-7; }

}  // namespace

TEST_CASE("without a zenith the background has one colour") {
    CHECK(background_color({.color = low}, {0, 1, 0}) == low);
    CHECK(background_color({.color = low}, {1, 1, 1}) == low);
}

TEST_CASE("a sky goes from the horizon's colour to the zenith's by the fourth power of one less the elevation's sine") {
    CHECK(background_color(sky, {1, 0, 0}) == low);
    CHECK(is_color(background_color(sky, {0, 3, 0}), high));
    CHECK(is_color(background_color(sky, {std::sqrt(3.0f), 1, 0}), high + 0.0625 * (low - high)));  // 30 degrees
    CHECK(is_color(background_color(sky, {0, 0.25f, -std::sqrt(0.9375f)}), high + 0.31640625 * (low - high)));
}

TEST_CASE("a background sends light unless it is black all around, the zenith included") {
    CHECK_FALSE(sends_light({}));
    CHECK_FALSE(sends_light({.zenith = Color{0, 0, 0}}));
    CHECK(sends_light({.color = low}));
    CHECK(sends_light({.zenith = high}));
}

TEST_CASE("below the horizon a sky has the horizon's colour") {
    CHECK(background_color(sky, {0, -1, 0}) == low);
    CHECK(background_color(sky, {1, -0.1f, 0}) == low);
}
