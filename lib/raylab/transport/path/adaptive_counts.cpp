#include "raylab/transport/path/adaptive_counts.h"

#include <algorithm>
#include <cassert>
#include <cmath>

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

}  // namespace

std::vector<int> adaptive_counts(const SampledImage& first, int mean, int fewest) {
    assert(first.at(0, 0).count >= 2 && mean >= fewest);
    std::vector<double> deviations;
    double sum = 0;
    for (int y = 0; y < first.height(); ++y)
        for (int x = 0; x < first.width(); ++x) {
            deviations.push_back(deviation_around(first, x, y));
            sum += deviations.back();
        }
    const double to_share = sum > 0 ? (mean - fewest) * static_cast<double>(deviations.size()) / sum : 0;
    std::vector<int> counts;
    for (const double deviation : deviations) counts.push_back(fewest + static_cast<int>(deviation * to_share));
    return counts;
}

}  // namespace raylab
