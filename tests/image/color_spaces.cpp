#include "catch.h"

#include "raylab/image/color_spaces.h"

#include <glm/geometric.hpp>

#include <cmath>

using namespace raylab;

TEST_CASE("white and black are the ends of the lightness axis, greys lie on it") {
    CHECK(glm::length(lab_from_rgb({1, 1, 1}) - glm::dvec3(100, 0, 0)) < 1e-12);
    CHECK(glm::length(lab_from_rgb({0, 0, 0})) < 1e-12);
    CHECK_THAT(lab_from_rgb({0.18, 0.18, 0.18}).x, WithinAbs(116 * std::cbrt(0.18) - 16, 1e-12));
}

TEST_CASE("sRGB red and blue have the L*a*b* coordinates found in tables") {
    // Lindbloom, "Color calculator" (sRGB, D65): red 53.2408 80.0925 67.2032, blue 32.2970 79.1875 -107.8602.
    CHECK(glm::length(lab_from_rgb({1, 0, 0}) - glm::dvec3(53.2408, 80.0925, 67.2032)) < 0.05);
    CHECK(glm::length(lab_from_rgb({0, 0, 1}) - glm::dvec3(32.2970, 79.1875, -107.8602)) < 0.05);
}

TEST_CASE("both spaces lead back to the colour they were made from") {
    for (const glm::dvec3& rgb : {glm::dvec3(0.2, 0.5, 0.9), {1e-4, 0, 2e-3}, {1, 0, 1}}) {
        CHECK(glm::length(rgb_from_lab(lab_from_rgb(rgb)) - rgb) < 1e-13);
        CHECK(glm::length(rgb_from_ycxcz(ycxcz_from_rgb(rgb)) - rgb) < 1e-13);
    }
}
