#include "catch.h"

#include "raylab/sampling/pixel_filter.h"
#include "raylab/sampling/sequence.h"

#include <cmath>

using namespace raylab;

namespace {

constexpr std::array all_filters{PixelFilter::box, PixelFilter::tent, PixelFilter::gaussian, PixelFilter::mitchell};

double integral(PixelFilter filter, double from, double to) {
    constexpr int steps = 20'000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) sum += filter_value(filter, from + (to - from) * (i + 0.5) / steps);
    return sum * (to - from) / steps;
}

}  // namespace

TEST_CASE("a filter's integral is 1") {
    for (const PixelFilter filter : all_filters) CHECK_THAT(integral(filter, -2.5, 2.5), WithinAbs(1, 1e-6));
}

TEST_CASE("samples and weights are as the filter has it, bin by bin") {
    constexpr int samples = 100'000, bins = 20;
    for (const PixelFilter filter : all_filters) {
        std::array<double, bins> sums{}, squares{};
        for (std::uint64_t i = 0; i < samples; ++i) {
            RandomSequence random(11, i);
            const double u = random.next();
            const auto [x, y, weight] = filter_sample(filter, {u, random.next()});
            const auto bin = static_cast<std::size_t>((x + 2.5) / 5 * bins);
            REQUIRE(bin < bins);
            sums[bin] += weight;
            squares[bin] += weight * weight;
        }
        for (std::size_t i = 0; i < bins; ++i) {
            const double low = -2.5 + 5.0 * static_cast<double>(i) / bins,
                         truth = integral(filter, low, low + 5.0 / bins);
            const double mean = sums[i] / samples;
            const double error = std::sqrt(std::max(0.0, squares[i] / samples - mean * mean) / samples);
            INFO(to_string(filter) << ", bin " << i << ": " << mean << " +- " << error << ", truth " << truth);
            CHECK(std::abs(mean - truth) <= 4.5 * error + 1e-5);
        }
    }
}

TEST_CASE("Mitchell's filter is what its paper prints for B = C = 1/3") {
    CHECK_THAT(filter_value(PixelFilter::mitchell, 0), WithinAbs(8.0 / 9, 1e-15));
    CHECK_THAT(filter_value(PixelFilter::mitchell, 1), WithinAbs(1.0 / 18, 1e-15));
    CHECK_THAT(filter_value(PixelFilter::mitchell, -1.5), WithinAbs(-5.0 / 144, 1e-15));
    CHECK(filter_value(PixelFilter::mitchell, 2) == 0);
}

TEST_CASE("filters have their names") {
    for (const PixelFilter filter : all_filters) CHECK(pixel_filter(to_string(filter)) == filter);
    CHECK_FALSE(pixel_filter("boxy"));
}
