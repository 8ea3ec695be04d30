#include "catch.h"

#include "raylab/image/color.h"
#include "raylab/image/color_map.h"

using namespace raylab;

TEST_CASE("every one of the 256 sRGB code values survives the way to linear light and back") {
    for (int code = 0; code < 256; ++code) {
        const auto stored = static_cast<float>(linear_from_srgb(code / 255.0));
        CHECK(srgb_byte(stored) == code);
    }
}

TEST_CASE("the two halves of the sRGB curve meet within the standard's own rounding") {
    // IEC 61966-2-1 rounds its constants to four or five digits, which leaves a jump of about 1e-8 of full scale.
    const double below = 0.04045 / 12.92, above = std::pow((0.04045 + 0.055) / 1.055, 2.4);
    CHECK_THAT(below, WithinAbs(above, 1e-7));
    CHECK(linear_from_srgb(0.04045) == below);
    CHECK_THAT(srgb_from_linear(0.0031308), WithinAbs(0.04045, 1e-6));
}

TEST_CASE("sRGB code values known from the standard's formula") {
    CHECK(linear_from_srgb(0) == 0.0);
    CHECK(linear_from_srgb(1) == 1.0);
    CHECK_THAT(linear_from_srgb(0.5), WithinAbs(0.21404114048223255, 1e-15));
    CHECK_THAT(srgb_from_linear(0.18), WithinAbs(0.46135612950044164, 1e-15));
    CHECK(srgb_byte(0.5) == 188);
}

TEST_CASE("what a screen cannot show is clamped, and NaN becomes black") {
    CHECK(srgb_byte(-1) == 0);
    CHECK(srgb_byte(7) == 255);
    CHECK(srgb_byte(std::numeric_limits<double>::infinity()) == 255);
    CHECK(srgb_byte(std::numeric_limits<double>::quiet_NaN()) == 0);
}

TEST_CASE("one stop more doubles the light") {
    const Image image(1, 1, {0.25f, 0.5f, 1});
    CHECK(exposed(image, 1).at(0, 0) == Pixel{0.5f, 1, 2});
    CHECK(exposed(image, -2).at(0, 0) == Pixel{0.0625f, 0.125f, 0.25f});
}

TEST_CASE("heat colours grow lighter with their number, from black to nearly white") {
    double before = -1;
    for (int i = 0; i <= 1000; ++i) {
        const double y = luminance(heat_color(i / 1000.0));
        REQUIRE(y > before);
        before = y;
    }
    CHECK(heat_color(0) == Pixel{0, 0, 0});
    CHECK(luminance(heat_color(1)) > 0.9);
}

TEST_CASE("heat colours have the CIE lightness they promise") {
    for (const double t : {0.25, 0.5, 0.75}) {
        const double lightness = 116 * std::cbrt(luminance(heat_color(t))) - 16;
        CHECK_THAT(lightness, WithinAbs(97 * t, 0.2));
    }
}
