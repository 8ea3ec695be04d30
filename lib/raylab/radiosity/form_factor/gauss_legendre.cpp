#include "raylab/radiosity/form_factor/gauss_legendre.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

namespace raylab {

namespace {

// The Legendre polynomial of a degree at x, and its derivative, by the three-term recurrence.
struct Legendre {
    double value, derivative;
};

Legendre legendre(int degree, double x) {
    double before = 1, value = x;
    for (int k = 2; k <= degree; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
    }
    return {value, degree * (x * value - before) / (x * x - 1)};
}

// The places are the polynomial's roots, found by Newton's method from Chebyshev's.
std::vector<GaussPoint> rule(int points) {
    std::vector<GaussPoint> found;
    for (int i = 0; i < points; ++i) {
        double x = -std::cos(std::numbers::pi * (i + 0.75) / (points + 0.5));
        for (int step = 0; step < 8; ++step) {  // six are enough for 16 points
            const Legendre at = legendre(points, x);
            x -= at.value / at.derivative;
        }
        const double slope = legendre(points, x).derivative;
        found.push_back({0.5 * (1 + x), 1 / ((1 - x * x) * slope * slope)});
    }
    return found;
}

}  // namespace

std::span<const GaussPoint> gauss_legendre(int points) {
    assert(points >= 1 && points <= most_gauss_points);
    static const auto rules = [] {
        std::array<std::vector<GaussPoint>, most_gauss_points> all;
        for (int n = 1; n <= most_gauss_points; ++n) all[static_cast<std::size_t>(n - 1)] = rule(n);
        return all;
    }();
    return rules[static_cast<std::size_t>(points - 1)];
}

}  // namespace raylab
