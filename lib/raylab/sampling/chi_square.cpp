#include "raylab/sampling/chi_square.h"

#include <cmath>
#include <numeric>

namespace raylab {

namespace {

// The regularised incomplete gamma functions P(a, x), by its series, and Q(a, x) = 1 - P(a, x), by its continued
// fraction (Abramowitz and Stegun, 6.5.29 and 6.5.31, the latter evaluated as Lentz does). Each is used where it
// converges fast, and both have one factor.
double common_factor(double a, double x) { return std::exp(a * std::log(x) - x - std::lgamma(a)); }

double gamma_p_by_series(double a, double x) {
    double term = 1 / a, sum = term;
    for (double n = a + 1; term > 1e-17 * sum; ++n) sum += term *= x / n;
    return sum * common_factor(a, x);
}

double gamma_q_by_fraction(double a, double x) {
    double b = x + 1 - a, c = 1e300, d = 1 / b, value = d;
    for (int i = 1; i < 10'000; ++i) {
        const double an = -i * (i - a);
        b += 2;
        d = 1 / (an * d + b);
        c = b + an / c;
        value *= c * d;
        if (std::abs(c * d - 1) < 1e-15) break;
    }
    return value * common_factor(a, x);
}

}  // namespace

double chi_square_tail(double statistic, double degrees) {
    const double a = degrees / 2, x = statistic / 2;
    if (!(x > 0)) return 1;
    return x < a + 1 ? 1 - gamma_p_by_series(a, x) : gamma_q_by_fraction(a, x);
}

double chi_square_p_value(std::span<const std::uint64_t> counts, std::span<const double> expected) {
    constexpr double enough = 5;
    double statistic = 0, degrees = -1, pooled_count = 0, pooled_expected = 0;
    const auto add = [&](double count, double expectation) {
        statistic += (count - expectation) * (count - expectation) / expectation;
        ++degrees;
    };
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const auto count = static_cast<double>(counts[i]);
        if (expected[i] >= enough) {
            add(count, expected[i]);
        } else {
            pooled_count += count;
            pooled_expected += expected[i];
        }
    }
    if (pooled_expected > 0) add(pooled_count, pooled_expected);
    if (pooled_expected == 0 && pooled_count > 0) return 0;  // what cannot happen did
    return degrees > 0 ? chi_square_tail(statistic, degrees) : 1;
}

double chi_square_p_value(std::span<const std::uint64_t> counts) {
    const auto sum = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
    return chi_square_p_value(counts, std::vector(counts.size(), sum / static_cast<double>(counts.size())));
}

}  // namespace raylab
