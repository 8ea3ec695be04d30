#pragma once

#include "raylab/image/sampled_image.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace raylab::test {

/// The |z| that the greatest of so many independent standard normal numbers exceeds with probability alpha (Sidak
/// 1967): each may with 1 - (1 - alpha)^(1 / count).
inline double sidak_limit(int count, double alpha) {
    const double each = -std::expm1(std::log1p(-alpha) / count);
    double low = 0, high = 40;
    for (int i = 0; i < 80; ++i) {
        const double middle = (low + high) / 2;
        (std::erfc(middle / std::numbers::sqrt2) > each ? low : high) = middle;
    }
    return low;
}

/// How far a picture is from its truth, in standard errors. A bias of all pixels shows in the mean long before it shows
/// in any of them, one of a single pixel the other way round.
struct Deviation {
    double mean;  // of the picture's mean
    double greatest;
    int pixels;

    /// Whether neither is so far away but by chance with probability alpha each.
    bool could_be_chance(double alpha) const {
        return std::abs(mean) <= sidak_limit(1, alpha) && greatest <= sidak_limit(pixels, alpha);
    }
};

/// Of the green channel; a pixel without variance must be right to twelve digits.
inline Deviation deviation(const SampledImage& image, const std::function<double(int x, int y)>& truth) {
    double difference = 0, variance = 0, greatest = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const double wrong = image.at(x, y).color.g / image.at(x, y).count - truth(x, y);
            const double of_pixel = image.variance_of_mean(x, y) + std::pow(1e-12 * truth(x, y), 2) + 1e-300;
            difference += wrong;
            variance += of_pixel;
            greatest = std::max(greatest, std::abs(wrong) / std::sqrt(of_pixel));
        }
    return {difference / std::sqrt(variance), greatest, image.width() * image.height()};
}

}  // namespace raylab::test
