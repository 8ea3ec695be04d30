#include "catch.h"

#include "raylab/image/compare.h"

#include <limits>

using namespace raylab;

namespace {

constexpr double nan_ = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
constexpr double denormal = std::numeric_limits<double>::denorm_min();

bool same(const Image& image, const Image& reference) { return objections(compare(image, reference)).empty(); }

Image ramp(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.at(x, y) = {0.2f + 0.6f * static_cast<float>(x) / static_cast<float>(width), 0.5f, 0.3f};
    return image;
}

// Adds to the red of `count` pixels, spread so that no window has more than one.
Image with_outliers(Image image, int count, float by) {
    for (int i = 0; i < count; ++i) image.at((16 * i) % image.width(), 16 * (16 * i / image.width())).r += by;
    return image;
}

}  // namespace

TEST_CASE("within: a difference inside absolute + relative |reference| passes, its sign does not matter") {
    const Tolerance t{1e-3, 1e-3};
    CHECK(within(0, 0, t));
    CHECK(within(-0.0, 0, t));
    CHECK(within(0, -0.0, t));
    CHECK(within(1e-3, 0, t));
    CHECK(within(-1.9e-3, 1, t));
    CHECK(within(1.9e-3, -1, t));
    CHECK_FALSE(within(2.1e-3, 1, t));
    CHECK_FALSE(within(-2.1e-3, 1, t));
}

TEST_CASE("within: what is not a finite number fails on either side") {
    const Tolerance t{1e-3, 1e-3};
    for (const double bad : {nan_, inf, -inf}) {
        CHECK_FALSE(within(bad, 1, t));
        CHECK_FALSE(within(0, bad, t));
        CHECK_FALSE(within(bad, bad, t));
    }
    CHECK_FALSE(within(0, 0, {nan_, 0}));
}

TEST_CASE("within: denormals are numbers like any other") {
    CHECK(within(denormal, 0, {1e-3, 1e-3}));
    CHECK(within(0, denormal, {0, 0}));
    CHECK_FALSE(within(denormal, 0, {0, 0}));
    CHECK(within(denormal, 0, {denormal, 0}));
}

TEST_CASE("a picture is the same as itself, an empty one too") {
    CHECK(same(ramp(40, 30), ramp(40, 30)));
    CHECK(same(Image(), Image()));
    CHECK(exact_objections(compare(ramp(40, 30), ramp(40, 30))).empty());
}

TEST_CASE("another size is an objection before anything else, even where values are not finite") {
    Image bad(4, 5);
    bad.at(0, 0).r = static_cast<float>(nan_);
    const auto found = objections(compare(bad, Image(5, 4)));
    REQUIRE(found.size() == 1);
    CHECK(found[0] == "the size is 4 x 5, the reference's 5 x 4");
    CHECK_FALSE(same(Image(), Image(1, 1)));
    CHECK_FALSE(same(Image(0, 3), Image(3, 0)));
}

TEST_CASE("one value that is not finite makes a difference, in any channel of either picture or of both") {
    for (const double bad : {nan_, inf, -inf})
        for (float Pixel::*channel : {&Pixel::r, &Pixel::g, &Pixel::b}) {
            Image broken = ramp(40, 30);
            broken.at(7, 3).*channel = static_cast<float>(bad);
            CHECK_FALSE(same(broken, ramp(40, 30)));
            CHECK_FALSE(same(ramp(40, 30), broken));
            CHECK_FALSE(same(broken, broken));
            CHECK_FALSE(exact_objections(compare(broken, broken)).empty());
        }
}

TEST_CASE("the first value that is not finite is named with its pixel") {
    Image broken = ramp(40, 30);
    broken.at(9, 4).g = static_cast<float>(inf);
    broken.at(7, 3).b = static_cast<float>(nan_);
    const auto found = objections(compare(broken, ramp(40, 30)));
    REQUIRE(found.size() == 1);
    CHECK(found[0].find("pixel (7, 3)") != std::string::npos);
}

TEST_CASE("an all-NaN picture differs from any reference, and so does any picture from an all-NaN reference") {
    const auto bad = static_cast<float>(nan_);
    CHECK_FALSE(same(Image(40, 30, {bad, bad, bad}), ramp(40, 30)));
    CHECK_FALSE(same(ramp(40, 30), Image(40, 30, {bad, bad, bad})));
}

TEST_CASE("rounding noise everywhere is the same picture") {
    Image image = ramp(64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) image.at(x, y).g += (x + y) % 2 ? 9e-4f : -9e-4f;
    CHECK(same(image, ramp(64, 64)));
}

TEST_CASE("half a percent of outliers passes, more does not") {
    const Image reference(160, 160, {0.5f, 0.5f, 0.5f});  // 0.5 % of 25600 pixels are 128
    CHECK(same(with_outliers(reference, 100, 0.1f), reference));
    const Comparison many =
        compare(with_outliers(Image(64, 48, {0.5f, 0.5f, 0.5f}), 12, 0.01f), Image(64, 48, {0.5f, 0.5f, 0.5f}));
    CHECK(many.share_over == 12.0 / (64 * 48));
    CHECK(objections(many).empty());
    const Comparison dense =
        compare(with_outliers(Image(32, 32, {0.5f, 0.5f, 0.5f}), 4, 0.01f), Image(32, 32, {0.5f, 0.5f, 0.5f}));
    CHECK(dense.share_over > 0.003);
    Image six(32, 32, {0.5f, 0.5f, 0.5f});
    for (int i = 0; i < 6; ++i) six.at(5 * i, 5 * i).r = 0.51f;
    CHECK_FALSE(same(six, Image(32, 32, {0.5f, 0.5f, 0.5f})));  // 6 of 1024 are 0.59 %
    Image five = six;
    five.at(0, 0).r = 0.5f;
    CHECK(same(five, Image(32, 32, {0.5f, 0.5f, 0.5f})));
}

TEST_CASE("a missing object of sixteen pixels is found wherever the windows lie") {
    // 17 of 64 pixels are more than a quarter; they are 0.04 % of the picture, and do not change the mean.
    for (int shift = 0; shift < 8; ++shift) {
        const Image reference(200, 200, {0.5f, 0.5f, 0.5f});
        Image image = reference;
        for (int i = 0; i < 36; ++i) image.at(40 + shift + i % 6, 40 + shift + i / 6) = {0.4f, 0.5f, 0.5f};
        const Comparison comparison = compare(image, reference);
        CHECK(comparison.share_over <= 0.005);
        CHECK_FALSE(comparison.bad_tiles.empty());
        CHECK(objections(comparison).size() == 1);
    }
}

TEST_CASE("a quarter of a window may be over tolerance, one pixel more may not") {
    const Image reference(200, 200, {0.5f, 0.5f, 0.5f});
    Image image = reference;
    for (int i = 0; i < 16; ++i) image.at(40 + i % 4, 40 + i / 4).r = 0.6f;
    CHECK(same(image, reference));
    image.at(44, 40).r = 0.6f;
    CHECK_FALSE(same(image, reference));
}

TEST_CASE("objections tell shares in per cent") {
    const auto found = objections(compare(Image(16, 16, {0.6f, 0.5f, 0.5f}), Image(16, 16, {0.5f, 0.5f, 0.5f})));
    REQUIRE(found.size() == 3);
    CHECK(found[0] == "100 % of the pixels are over tolerance, 0.5 % may be");
    CHECK(found[1].ends_with("have more than 25 % of their pixels over tolerance, the worst 100 % at (0, 0)"));
    CHECK(found[2] == "the mean red is 0.6, the reference's 0.5: more than 0.2 % apart");
}

TEST_CASE("a mean that is off by a third of a percent differs though every pixel is within tolerance") {
    const Image reference(64, 64, {0.5f, 0.25f, 0.5f});
    Image image(64, 64, {0.5f, 0.2508f, 0.5f});
    const Comparison comparison = compare(image, reference);
    CHECK(comparison.share_over == 0);
    const auto found = objections(comparison);
    REQUIRE(found.size() == 1);
    CHECK(found[0].find("mean green") != std::string::npos);
    CHECK(same(Image(64, 64, {0.5f, 0.2503f, 0.5f}), reference));
}

TEST_CASE("the numbers are those of their definitions") {
    const Image reference(2, 1, {1, 0, 0});
    Image image = reference;
    image.at(1, 0) = {0, 0, 0.5f};
    const Comparison c = compare(image, reference);
    CHECK(c.max_error == 1);
    CHECK_THAT(c.rmse, WithinRel(std::sqrt(1.25 / 6), 1e-15));
    const double floor = 0.01 / 9;  // the mean over all channels is 1/3
    CHECK_THAT(c.relative_mse, WithinRel((1 / (1 + floor) + 0.25 / floor) / 6, 1e-6));
    CHECK(c.bits_differ == 1);
    REQUIRE(c.worst.size() == 1);
    CHECK(c.worst[0].x == 1);
    CHECK(c.worst[0].error == 1);
    CHECK(c.worst[0].reference == Pixel{1, 0, 0});
    CHECK(c.mean_flip > 0);
}

TEST_CASE("the worst pixels come worst first, one of each block, ties in reading order, ten at most") {
    Image image(120, 1);
    for (int x = 0; x < 120; ++x) image.at(x, 0).r = x == 20 ? 0.9f : 0.5f;
    const Comparison c = compare(image, Image(120, 1));
    REQUIRE(c.worst.size() == 10);
    CHECK(c.max_error == c.worst[0].error);
    CHECK(c.worst[0].x == 20);
    CHECK(c.worst[1].x == 0);
    CHECK(c.worst[9].x == 72);
}

TEST_CASE("a black reference has a finite relative error, zero for a black picture") {
    CHECK(compare(Image(9, 9), Image(9, 9)).relative_mse == 0);
    CHECK(std::isfinite(compare(Image(9, 9, {1e-3f, 0, 0}), Image(9, 9)).relative_mse));
}

TEST_CASE("the same bits: -0 is not 0, one unit in the last place is a difference") {
    Image image = ramp(40, 30);
    image.at(3, 2).r = std::nextafter(image.at(3, 2).r, 1.0f);
    CHECK(same(image, ramp(40, 30)));
    CHECK(exact_objections(compare(image, ramp(40, 30))).size() == 1);
    const Image zero(1, 1), negative(1, 1, {-0.0f, 0, 0});
    CHECK(same(zero, negative));
    CHECK_FALSE(exact_objections(compare(zero, negative)).empty());
}

TEST_CASE("the largest floats compare without overflow") {
    const float largest = std::numeric_limits<float>::max();
    CHECK(same(Image(8, 8, {largest, 0, 0}), Image(8, 8, {largest, 0, 0})));
    CHECK_FALSE(same(Image(8, 8, {largest, 0, 0}), Image(8, 8, {-largest, 0, 0})));
}
