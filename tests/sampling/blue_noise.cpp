#include "catch.h"

#include "raylab/sampling/pattern/blue_noise_mask.h"
#include "raylab/sampling/sampler.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

using namespace raylab;

namespace {

// An edge crosses every pixel, so each is a mean of zeros and ones. What the eye sees of the noise is its mean over
// some pixels.
double blurred_error(SamplerKind kind, int samples) {
    constexpr int side = 64, blur = 8;
    std::vector<double> errors(side * side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            for (int i = 0; i < samples; ++i) {
                const auto number = static_cast<std::uint64_t>(y * side + x);
                const auto [u, v] =
                    pair({.kind = kind, .count = samples}, {.pixel = number, .x = x, .y = y, .index = i}, 0);
                errors[number] += ((u + 0.5 * v < 0.7 ? 1.0 : 0.0) - 0.45) / samples;
            }
    double squares = 0;
    for (int y = 0; y < side; y += blur)
        for (int x = 0; x < side; x += blur) {
            double mean = 0;
            for (int i = 0; i < blur * blur; ++i)
                mean += errors[static_cast<std::size_t>((y + i / blur) * side + x + i % blur)] / (blur * blur);
            squares += mean * mean;
        }
    return std::sqrt(squares);
}

}  // namespace

TEST_CASE("each rank of the blue-noise mask is there once, and the mask repeats") {
    const BlueNoiseMask& mask = BlueNoiseMask::instance();
    std::vector<bool> seen(BlueNoiseMask::pixels);
    for (std::uint32_t y = 0; y < BlueNoiseMask::side; ++y)
        for (std::uint32_t x = 0; x < BlueNoiseMask::side; ++x) seen[mask.rank(x, y)] = true;
    CHECK(std::ranges::all_of(seen, [](bool was) { return was; }));
    CHECK(mask.rank(3, 5) == mask.rank(3 + BlueNoiseMask::side, 5 + 7 * BlueNoiseMask::side));
}

TEST_CASE(
    "the mask has hardly any low frequencies: of 16 waves or fewer across it, a hundredth of white noise's power") {
    const BlueNoiseMask& mask = BlueNoiseMask::instance();
    constexpr double side = BlueNoiseMask::side, n = BlueNoiseMask::pixels;
    const auto power = [&](int waves_x, int waves_y) {
        std::complex<double> sum = 0;
        for (std::uint32_t y = 0; y < BlueNoiseMask::side; ++y)
            for (std::uint32_t x = 0; x < BlueNoiseMask::side; ++x)
                sum += std::polar(mask.rank(x, y) / n, -2 * std::numbers::pi * (waves_x * x + waves_y * y) / side);
        return std::norm(sum) / (n / 12);  // the variance of a uniform number is 1/12
    };
    double low = 0;
    int count = 0;
    for (int y = 0; y <= 12; ++y)
        for (int x = 0; x <= 12; ++x)
            if (x * x + y * y > 0 && x * x + y * y <= 144) {
                low += power(x, y);
                ++count;
            }
    INFO("mean power " << low / count);
    CHECK(low / count < 0.01);
}

TEST_CASE("blurred over 8 x 8 pixels, blue-noise samples err half as much as Sobol's: where a pixel has one") {
    CHECK(blurred_error(SamplerKind::blue_noise, 1) < 0.6 * blurred_error(SamplerKind::sobol, 1));
    CHECK(blurred_error(SamplerKind::blue_noise, 4) < 0.9 * blurred_error(SamplerKind::sobol, 4));
    CHECK(blurred_error(SamplerKind::blue_noise, 64) < 1.2 * blurred_error(SamplerKind::sobol, 64));
}
