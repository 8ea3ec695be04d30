#include "raylab/image/noisy_picture.h"

#include "raylab/image/color.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

// Beyond how many standard deviations, on either side, a normal number is with this probability.
double deviations(double probability) {
    double low = 0, high = 40;
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (std::erfc(middle / std::sqrt(2.0)) > probability ? low : high) = middle;
    }
    return high;
}

// Means over a window, and the variance of their difference.
struct WindowMeans {
    int x = 0, y = 0;
    double yours = 0, reference = 0, variance = 0, pixels = 0;

    double difference() const { return std::abs(yours - reference) / pixels; }
    // It is written positively, so that NaN is no agreement.
    bool agrees(double sigmas, const Tolerance& bias) const {
        const double noise = sigmas * std::sqrt(variance) / pixels;
        return difference() <= noise + bias.absolute + bias.relative * reference / pixels;
    }
};

// The variance of one sample, as the reference's samples show it.
double sample_variance(const SampledImage& reference, int x, int y) {
    return reference.variance_of_mean(x, y) * reference.at(x, y).count;
}

double difference_variance(const SampledImage& reference, int x, int y, int samples) {
    return sample_variance(reference, x, y) / samples + reference.variance_of_mean(x, y);
}

WindowMeans window(const Image& image, const Image& mean, const SampledImage& reference, int x0, int y0, int width,
                   int height, int samples) {
    WindowMeans sums{.x = x0, .y = y0};
    for (int y = y0; y < std::min(y0 + height, image.height()); ++y)
        for (int x = x0; x < std::min(x0 + width, image.width()); ++x) {
            sums.yours += luminance(image.at(x, y));
            sums.reference += luminance(mean.at(x, y));
            sums.variance += difference_variance(reference, x, y, samples);
            ++sums.pixels;
        }
    return sums;
}

std::size_t count_fireflies(const Image& image, const Image& mean, const SampledImage& reference,
                            const NoisyTolerance& tolerance) {
    std::size_t count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const double sigma = std::sqrt(difference_variance(reference, x, y, tolerance.samples));
            const double expected = luminance(mean.at(x, y));
            const double allowed = tolerance.firefly * sigma + tolerance.bias.absolute + 0.1 * expected;
            count += !(std::abs(luminance(image.at(x, y)) - expected) <= allowed);
        }
    return count;
}

}  // namespace

std::vector<std::string> noisy_objections(const Image& image, const SampledImage& reference,
                                          const NoisyTolerance& tolerance) {
    const Image mean = reference.mean();
    if (const auto comparison = compare(image, mean); !comparison.comparable()) return objections(comparison);
    std::vector<WindowMeans> windows;
    for (int y = 0; y < image.height(); y += tolerance.block)
        for (int x = 0; x < image.width(); x += tolerance.block)
            windows.push_back(
                window(image, mean, reference, x, y, tolerance.block, tolerance.block, tolerance.samples));
    const auto whole = window(image, mean, reference, 0, 0, image.width(), image.height(), tolerance.samples);
    // Sidak: so that all tests together refuse alpha of the right pictures.
    const double each = -std::expm1(std::log1p(-tolerance.alpha) / static_cast<double>(windows.size() + 1));
    const double sigmas = deviations(each);

    std::vector<std::string> found;
    std::erase_if(windows, [&](const auto& one) { return one.agrees(sigmas, tolerance.bias); });
    if (!windows.empty()) {
        const auto& worst = *std::ranges::max_element(windows, {}, &WindowMeans::difference);
        found.push_back(fmt::format(
            "{} windows of {} x {} pixels have another mean than noise explains, the worst at ({}, {}): {:.4g}, "
            "expected {:.4g} within {:.2g}",
            windows.size(), tolerance.block, tolerance.block, worst.x, worst.y, worst.yours / worst.pixels,
            worst.reference / worst.pixels, sigmas * std::sqrt(worst.variance) / worst.pixels));
    }
    if (!whole.agrees(sigmas, tolerance.bias))
        found.push_back(fmt::format("the mean of all pixels is {:.4g}, expected {:.4g} within {:.2g}",
                                    whole.yours / whole.pixels, whole.reference / whole.pixels,
                                    sigmas * std::sqrt(whole.variance) / whole.pixels));
    const auto fireflies = count_fireflies(image, mean, reference, tolerance);
    if (!(static_cast<double>(fireflies) <= tolerance.firefly_share * whole.pixels))
        found.push_back(
            fmt::format("{} pixels are more than {:g} standard deviations off", fireflies, tolerance.firefly));
    return found;
}

}  // namespace raylab
