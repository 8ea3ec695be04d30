#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace raylab {

/// The next float above x, finite and not -infinity or NaN. (std::nextafter is a call of its own.)
constexpr float next_above(float x) {
    if (x == 0) return std::bit_cast<float>(std::uint32_t{1});
    const auto bits = std::bit_cast<std::uint32_t>(x);
    return std::bit_cast<float>(x > 0 ? bits + 1 : bits - 1);
}

/// The first float beyond x: above it if `toward` is positive, below it otherwise. x fits a float.
constexpr float float_beyond(double x, double toward) {
    const auto nearest = static_cast<float>(x);
    if (toward > 0) return nearest > x ? nearest : next_above(nearest);
    return nearest < x ? nearest : -next_above(-nearest);
}

/// The first float not below x: infinite beyond the largest.
constexpr float rounded_up(double x) {
    constexpr float largest = std::numeric_limits<float>::max();
    if (x > largest) return std::numeric_limits<float>::infinity();
    if (x < -largest) return -largest;
    const auto nearest = static_cast<float>(x);
    return nearest < x ? next_above(nearest) : nearest;
}

}  // namespace raylab
