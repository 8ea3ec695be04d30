#include "raylab/radiosity/form_factor/tanh_sinh.h"

#include <cassert>
#include <cstddef>
#include <numbers>

namespace raylab {

namespace {

// x(t) = 1 / (1 + exp(pi sinh t)), and its derivative's absolute value; t > 0 gives the lower half of [0, 1].
std::vector<TanhSinhPoint> points_of(int level) {
    constexpr double last_t = 3.4;  // beyond, the weight is less than 1e-19
    std::vector<TanhSinhPoint> points;
    for (int k = 1; std::ldexp(k, -level) <= last_t; level == 0 ? ++k : k += 2) {
        const double t = std::ldexp(k, -level), u = std::exp(-std::numbers::pi * std::sinh(t));
        points.push_back({u / (1 + u), std::numbers::pi * std::cosh(t) * u / ((1 + u) * (1 + u))});
    }
    return points;
}

}  // namespace

const std::vector<TanhSinhPoint>& tanh_sinh_points(int level) {
    assert(level >= 0 && level < most_tanh_sinh_levels);
    static const auto levels = [] {
        std::array<std::vector<TanhSinhPoint>, most_tanh_sinh_levels> all;
        for (int i = 0; i < most_tanh_sinh_levels; ++i) all[static_cast<std::size_t>(i)] = points_of(i);
        return all;
    }();
    return levels[static_cast<std::size_t>(level)];
}

}  // namespace raylab
