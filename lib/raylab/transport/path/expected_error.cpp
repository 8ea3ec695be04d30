#include "raylab/transport/path/expected_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab {

namespace {

// The 95th percentile of the F distribution (Paulson, "An Approximate Normalization of the Analysis of Variance
// Distribution", Annals of Mathematical Statistics 13, 1942: cube roots of chi-square are nearly normal).
double f_quantile(double above, double below) {
    constexpr double z = 1.6448536269514722;
    const double a = 2 / (9 * above), b = 2 / (9 * below);
    const double p = 1 - a, q = 1 - b;
    const double denominator = q * q - b * z * z;
    const double root = (p * q + z * std::sqrt(p * p * b + q * q * a - a * b * z * z)) / denominator;
    return root * root * root;
}

}  // namespace

ExpectedError expected_error(const SampledImage& image) {
    double variance = 0, squares = 0, summands = std::numeric_limits<double>::infinity();
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const double v = image.variance_of_mean(x, y);
            variance += v;
            squares += v * v;
            summands = std::min(summands, static_cast<double>(image.at(x, y).count));
        }
    const double error = image.relative_error();
    if (!(variance > 0) || !std::isfinite(variance)) return {error, error};
    const double matter = variance * variance / squares;
    return {error, error * std::sqrt(f_quantile(matter, matter * (summands - 1)))};
}

}  // namespace raylab
