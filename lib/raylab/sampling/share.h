#pragma once

#include <cmath>
#include <cstdint>

namespace raylab {

/// The share of successes in a number of independent trials, with the interval that contains the true probability in 95
/// of 100 such experiments.
struct Share {
    std::uint64_t happened, trials;
    double low, high;

    double value() const { return static_cast<double>(happened) / static_cast<double>(trials); }
};

/// The score interval of E. B. Wilson, "Probable Inference, the Law of Succession, and Statistical Inference", Journal
/// of the American Statistical Association 22 (1927): it stays in [0, 1] and is useful even for no success at all.
inline Share share_of(std::uint64_t happened, std::uint64_t trials) {
    constexpr double z = 1.959963984540054;  // 95 % of the normal distribution lie within z deviations
    const auto n = static_cast<double>(trials), p = static_cast<double>(happened) / n;
    const double center = (p + z * z / (2 * n)) / (1 + z * z / n);
    const double half = z / (1 + z * z / n) * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
    return {happened, trials, happened == 0 ? 0 : center - half, happened == trials ? 1 : center + half};
}

}  // namespace raylab
