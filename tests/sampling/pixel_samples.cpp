#include "catch.h"

#include "raylab/sampling/pixel_samples.h"

#include <set>
#include <utility>

using namespace raylab;

namespace {

constexpr SamplePattern every_pattern[] = {SamplePattern::center, SamplePattern::corner, SamplePattern::jittered,
                                           SamplePattern::random};

PixelPoint mean(const PixelSamples& samples, std::uint64_t pixel) {
    PixelPoint sum{0, 0};
    for (int i = 0; i < samples.count(); ++i) {
        const PixelPoint p = pixel_sample(samples, pixel, i);
        sum.x += p.x / samples.count();
        sum.y += p.y / samples.count();
    }
    return sum;
}

}  // namespace

TEST_CASE("one sample is the pixel's centre, or its corner") {
    const PixelPoint center = pixel_sample({}, 7, 0), corner = pixel_sample({.pattern = SamplePattern::corner}, 7, 0);
    CHECK(center.x == 0.5);
    CHECK(center.y == 0.5);
    CHECK(corner.x == 0);
    CHECK(corner.y == 0);
}

TEST_CASE("every sample lies in its pixel") {
    for (const SamplePattern pattern : every_pattern)
        for (std::uint64_t pixel = 0; pixel < 100; ++pixel)
            for (int i = 0; i < 25; ++i) {
                const PixelPoint p = pixel_sample({.pattern = pattern, .per_side = 5}, pixel, i);
                const bool inside = p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1;
                REQUIRE(inside);
            }
}

TEST_CASE("every cell has one sample, but for random ones") {
    for (const SamplePattern pattern : {SamplePattern::center, SamplePattern::corner, SamplePattern::jittered}) {
        std::set<std::pair<int, int>> cells;
        for (int i = 0; i < 64; ++i) {
            const PixelPoint p = pixel_sample({.pattern = pattern, .per_side = 8}, 3, i);
            cells.emplace(static_cast<int>(8 * p.x), static_cast<int>(8 * p.y));
        }
        CHECK(cells.size() == 64);
    }
}

TEST_CASE("corner samples lie half a cell up and left of the pixel's middle on average, all others in it") {
    const auto off = [](SamplePattern pattern) { return mean({.pattern = pattern, .per_side = 4}, 1).x - 0.5; };
    CHECK(off(SamplePattern::corner) == -0.125);
    CHECK(off(SamplePattern::center) == 0);
    // 4000 pixels of 16 samples: the mean of a uniform number then has a standard deviation of 0.0011.
    for (const SamplePattern pattern : {SamplePattern::jittered, SamplePattern::random}) {
        double sum = 0;
        for (std::uint64_t pixel = 0; pixel < 4000; ++pixel) sum += mean({.pattern = pattern, .per_side = 4}, pixel).x;
        CHECK_THAT(sum / 4000, WithinAbs(0.5, 0.005));
    }
}

TEST_CASE("a sample depends on seed, pixel and index alone") {
    const PixelSamples samples{.pattern = SamplePattern::jittered, .per_side = 3};
    const PixelPoint late = pixel_sample(samples, 5, 8);
    pixel_sample(samples, 4, 1);
    CHECK(pixel_sample(samples, 5, 8).x == late.x);
    CHECK(pixel_sample(samples, 6, 8).x != late.x);
    CHECK(pixel_sample({.pattern = SamplePattern::jittered, .per_side = 3, .seed = 2}, 5, 8).x != late.x);
}
