#include "catch.h"

#include "raylab/image/noisy_picture.h"

#include <cmath>
#include <limits>
#include <random>

// Pictures of exponentially distributed samples, whose variance is the square of their mean: as skew as light paths.

using namespace raylab;

namespace {

constexpr int width = 48, height = 32;

double light(int x, int y) { return 0.2 + 0.01 * x + (y > 16 ? 0.3 : 0.0); }

SampledImage sampled(int samples, std::uint64_t seed, const auto& mean_at) {
    std::mt19937_64 random(seed);
    SampledImage image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int i = 0; i < samples; ++i) {
                const double value = std::exponential_distribution(1 / mean_at(x, y))(random);
                image.at(x, y).add({value, value, value});
            }
    return image;
}

const SampledImage& noisy_reference() {
    static const SampledImage image = sampled(2048, 1, light);
    return image;
}

std::vector<std::string> found(const Image& image) {
    return noisy_objections(image, noisy_reference(), {.samples = 16});
}

}  // namespace

TEST_CASE("pictures of the same light are taken, however their noise falls") {
    for (std::uint64_t seed = 2; seed < 62; ++seed) {
        const auto objections = found(sampled(16, seed, light).mean());
        INFO(seed << ": " << (objections.empty() ? "" : objections.front()));
        CHECK(objections.empty());
    }
}

TEST_CASE(
    "what noise does not explain is found: a darker corner, a darker whole, too few samples, single bright pixels") {
    const auto darker = [](int x, int y) { return light(x, y) * (x < 8 && y < 8 ? 0.4 : 1); };
    CHECK(found(sampled(16, 2, darker).mean()).front().find("the worst at (0, 0)") != std::string::npos);
    const auto all_darker = [](int x, int y) { return 0.9 * light(x, y); };
    CHECK(!found(sampled(16, 2, all_darker).mean()).empty());
    CHECK(!found(sampled(1, 2, light).mean()).empty());
    Image bright = sampled(16, 2, light).mean();
    for (int i = 0; i < 8; ++i) bright.at(5 * i, 3 * i) = {40, 40, 40};
    CHECK(found(bright).back().find("standard deviations off") != std::string::npos);
}

TEST_CASE("another size and a value that is no number are told before all else") {
    CHECK(found(Image(width, height + 1)).size() == 1);
    Image image = sampled(16, 2, light).mean();
    image.at(3, 4).g = std::numeric_limits<float>::quiet_NaN();
    const auto objections = found(image);
    REQUIRE(objections.size() == 1);
    CHECK(objections.front().find("(3, 4)") != std::string::npos);
}
