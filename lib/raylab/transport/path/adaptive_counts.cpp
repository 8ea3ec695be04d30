#include "raylab/transport/path/adaptive_counts.h"

#include "raylab/sampling/random.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace raylab {

namespace {

// The deviation of one sample, from the variance of all means around the pixel.
double deviation_around(const SampledImage& image, int x, int y) {
    double variance = 0;
    int pixels = 0;
    for (int v = std::max(0, y - 1); v <= std::min(image.height() - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(image.width() - 1, x + 1); ++u) {
            variance += image.variance_of_mean(u, v) * image.at(u, v).count;
            ++pixels;
        }
    return std::sqrt(variance / pixels);
}

// How many samples each pixel should have, of which no fewer than `fewest`, in proportion to its deviation.
std::vector<double> wanted_counts(const SampledImage& first, int mean, int fewest) {
    std::vector<double> wanted;
    double sum = 0;
    for (int y = 0; y < first.height(); ++y)
        for (int x = 0; x < first.width(); ++x) {
            wanted.push_back(deviation_around(first, x, y));
            sum += wanted.back();
        }
    const double to_share = sum > 0 ? (mean - fewest) * static_cast<double>(wanted.size()) / sum : 0;
    for (double& each : wanted) each = fewest + each * to_share;
    return wanted;
}

}  // namespace

std::vector<int> adaptive_counts(const SampledImage& first, int mean, int fewest) {
    assert(first.at(0, 0).count >= 2 && mean >= fewest);
    const std::vector<double> wanted = wanted_counts(first, mean, fewest);
    std::vector<int> counts;
    auto left = static_cast<std::int64_t>(mean) * static_cast<std::int64_t>(wanted.size());
    for (const double each : wanted) {
        counts.push_back(static_cast<int>(std::bit_floor(static_cast<unsigned>(each))));
        left -= counts.back();
    }
    // What rounding down has left goes to those that want nearly twice as many, equal ones in any order.
    std::vector<std::size_t> order(wanted.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto key = [&](std::size_t i) { return std::pair(-wanted[i] / counts[i], random_bits({.pixel = i})); };
    std::ranges::sort(order, {}, key);
    for (const std::size_t i : order) {
        if (counts[i] > left) continue;
        left -= counts[i];
        counts[i] *= 2;
    }
    return counts;
}

}  // namespace raylab
