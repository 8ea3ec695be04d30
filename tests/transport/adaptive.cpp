#include "catch.h"
#include "transport/sampled.h"

#include "raylab/transport/path/adaptive_counts.h"

#include <algorithm>
#include <bit>
#include <numeric>

// Tests of adaptive sampling: samples are spent where a first picture is noisy, and cost no bias.

using namespace raylab;
using namespace raylab::test;

namespace {

// A screen hides the right half; beside its edge the floor has a narrow penumbra, and full light on the left.
const char* const penumbra = R"(
[image]
width = 24
height = 8
[camera]
type = "orthographic"
position = [0, 3, 0]
target = [0, 0, 0]
up = [0, 0, -1]
height = 1
[material.floor]
diffuse = [1, 1, 1]
[material.light]
diffuse = [0, 0, 0]
emission = [1, 1, 1]
[material.screen]
diffuse = [0, 0, 0]
[[shape]]
type = "plane"
point = [0, 0, 0]
normal = [0, 1, 0]
material = "floor"
[[shape]]
type = "polygon"
vertices = [[-0.5, 4, -0.5], [0.5, 4, -0.5], [0.5, 4, 0.5], [-0.5, 4, 0.5]]
material = "light"
[[shape]]
type = "polygon"
vertices = [[0, 1, -5], [5, 1, -5], [5, 1, 5], [0, 1, 5]]
material = "screen"
)";

}  // namespace

TEST_CASE("the mean of all counts is as asked, each is a power of two, none below the fewest, most where it is noisy") {
    const Sampled stage(penumbra);
    const std::vector<int> counts = adaptive_counts(stage.sampled(16), 64);
    const double mean = std::accumulate(counts.begin(), counts.end(), 0.0) / static_cast<double>(counts.size());
    CHECK(mean <= 64);
    CHECK(mean > 63);
    CHECK(std::ranges::all_of(counts, [](int count) { return std::has_single_bit(static_cast<unsigned>(count)); }));
    CHECK(*std::ranges::min_element(counts) >= 4);
    CHECK(*std::ranges::max_element(counts) > 2 * mean);
}

TEST_CASE("adaptive pictures have the same mean, and a smaller error for as many samples", "[long]") {
    const Sampled stage(penumbra);
    const int width = stage.scene.image.width, height = stage.scene.image.height;
    const SampledImage truth = stage.sampled(16384, 99);
    constexpr int seeds = 40, samples = 64;
    double even = 0, adaptive = 0, difference = 0, variance = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const SampledImage uniform = stage.sampled(samples, seed);
        SampledImage image(width, height);
        const auto counts = adaptive_counts(stage.sampled(8, seed + 1000), samples - 8);
        stage.picture.add(image, {SamplerKind::random, samples, seed + 5000}, counts);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const auto mean = [&](const SampledImage& of) { return of.at(x, y).color.g / of.at(x, y).count; };
                even += std::pow(mean(uniform) - mean(truth), 2);
                adaptive += std::pow(mean(image) - mean(truth), 2);
                difference += mean(image) - mean(truth);
                variance += image.variance_of_mean(x, y) + truth.variance_of_mean(x, y) * seeds;
            }
    }
    INFO("squared error " << adaptive << " for " << even);
    CHECK(adaptive < 0.8 * even);
    CHECK(std::abs(difference) < 4 * std::sqrt(variance));
}

TEST_CASE("adaptive pictures are the same bits on any number of threads", "[threads]") {
    const Sampled stage(penumbra);
    const std::vector<int> counts = adaptive_counts(stage.sampled(8), 32);
    const auto drawn = [&](int threads) {
        SampledImage image(stage.scene.image.width, stage.scene.image.height);
        stage.picture.add(image, {.seed = 4}, counts, threads);
        return image;
    };
    const SampledImage one = drawn(1), four = drawn(4);
    for (int y = 0; y < one.height(); ++y)
        for (int x = 0; x < one.width(); ++x) CHECK(one.at(x, y).color == four.at(x, y).color);
}
