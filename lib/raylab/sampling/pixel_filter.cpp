#include "raylab/sampling/pixel_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raylab {

namespace {

constexpr std::array<std::string_view, 4> filter_words{"box", "tent", "gaussian",
                                                       "mitchell"};  // in PixelFilter's order

// One coordinate of a sample.
struct AlongAxis {
    double x, weight;
};

AlongAxis tent(double u) { return {u < 0.5 ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u), 1}; }

// The integral from 0 to x >= 0 of the Gaussian's density, up to its normalisation.
constexpr double gaussian_end = 2;
double gaussian_up_to(double x) { return std::erf(x * std::numbers::sqrt2); }

// x >= 0 at which a rising function reaches a value: 60 halvings of an interval that contains it.
template <class Rising>
double where_it_reaches(const Rising& rising, double value, double low, double high) {
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (rising(middle) < value ? low : high) = middle;
    }
    return (low + high) / 2;
}

// Half of the numbers stand for each side; what is left is in [0, 1).
AlongAxis on_either_side(double u, const auto& at_distance) {
    const bool left = u < 0.5;
    AlongAxis found = at_distance(left ? 2 * u : 2 * u - 1);
    if (left) found.x = -found.x;
    return found;
}

AlongAxis gaussian(double u) {
    return on_either_side(u, [](double share) {
        return AlongAxis{where_it_reaches(gaussian_up_to, share * gaussian_up_to(gaussian_end), 0, gaussian_end), 1};
    });
}

// Mitchell's filter with B = C = 1/3 in its two pieces, and their integrals from 0 and from 1. It changes its sign at
// 8/7: 21 x^3 - 36 x^2 + 16 is positive below 1, and beyond it is -(7 x - 8) (x - 2)^2 / 18.
double mitchell(double x) {
    if (x < 1) return (21 * x * x * x - 36 * x * x + 16) / 18;
    if (x < 2) return -(7 * x - 8) * (x - 2) * (x - 2) / 18;
    return 0;
}
double mitchell_up_to(double x) {
    const auto inner = [](double y) { return (21 * y * y * y * y / 4 - 12 * y * y * y + 16 * y) / 18; };
    const auto outer = [](double y) { return (-7 * y * y * y * y / 4 + 12 * y * y * y - 30 * y * y + 32 * y) / 18; };
    return x < 1 ? inner(x) : inner(1) + outer(x) - outer(1);
}

AlongAxis mitchell_sample(double u) {
    constexpr double zero = 8.0 / 7;
    static const double positive = mitchell_up_to(zero), negative = positive - mitchell_up_to(2);
    static const double size = positive + negative;  // of |f|; f's own is 1/2
    return on_either_side(u, [](double share) -> AlongAxis {
        const double reached = share * size;
        if (reached < positive) return {where_it_reaches(mitchell_up_to, reached, 0, zero), 2 * size};
        const auto below = [](double x) { return 2 * positive - mitchell_up_to(x); };
        return {where_it_reaches(below, reached, zero, 2), -2 * size};
    });
}

AlongAxis along_axis(PixelFilter filter, double u) {
    switch (filter) {
        case PixelFilter::box:
            break;
        case PixelFilter::tent:
            return tent(u);
        case PixelFilter::gaussian:
            return gaussian(u);
        case PixelFilter::mitchell:
            return mitchell_sample(u);
    }
    return {u - 0.5, 1};
}

}  // namespace

FilterSample filter_sample(PixelFilter filter, const std::array<double, 2>& numbers) {
    const AlongAxis x = along_axis(filter, numbers[0]), y = along_axis(filter, numbers[1]);
    return {x.x, y.x, x.weight * y.weight};
}

double filter_value(PixelFilter filter, double x) {
    const double distance = std::abs(x);
    switch (filter) {
        case PixelFilter::box:
            break;
        case PixelFilter::tent:
            return std::max(0.0, 1 - distance);
        case PixelFilter::gaussian:
            if (distance > gaussian_end) return 0;
            return std::exp(-2 * x * x) * std::sqrt(2 / std::numbers::pi) / gaussian_up_to(gaussian_end);
        case PixelFilter::mitchell:
            return mitchell(distance);
    }
    return distance <= 0.5 ? 1 : 0;
}

std::string to_string(PixelFilter filter) { return std::string(filter_words.at(static_cast<std::size_t>(filter))); }

std::vector<std::string> filter_names() { return {filter_words.begin(), filter_words.end()}; }

std::optional<PixelFilter> pixel_filter(std::string_view name) {
    const auto found = std::ranges::find(filter_words, name);
    if (found == filter_words.end()) return std::nullopt;
    return static_cast<PixelFilter>(found - filter_words.begin());
}

}  // namespace raylab
