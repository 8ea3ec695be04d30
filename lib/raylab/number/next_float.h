#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace raylab {

/// The next float above x, which must be finite or infinity, not -infinity or NaN. (std::nextafter would be a function
/// call.)
constexpr float next_above(float x) {
    if (x == 0) return std::bit_cast<float>(std::uint32_t{1});
    const auto bits = std::bit_cast<std::uint32_t>(x);
    return std::bit_cast<float>(x > 0 ? bits + 1 : bits - 1);
}

namespace detail {

[[gnu::cold]] constexpr float float_beyond_about_zero(double x, double toward) {
    const auto nearest = static_cast<float>(x);
    if (toward > 0) return nearest > x ? nearest : next_above(nearest);
    return nearest < x ? nearest : -next_above(-nearest);
}

}  // namespace detail

/// The first float beyond x: above it if `toward` is positive, below it if it is negative. x must be in a float's
/// range.
constexpr float float_beyond(double x, double toward) {
    constexpr auto sign = std::uint64_t{1} << 63,
                   min_normal = std::bit_cast<std::uint64_t>(double{std::numeric_limits<float>::min()});
    const auto bits = std::bit_cast<std::uint64_t>(x);
    // Subnormal floats have fewer bits than the step below assumes.
    if ((bits & ~sign) <= min_normal) return detail::float_beyond_about_zero(x, toward);
    // A double is a float where its last 29 bits are zero. Away from zero the next float is found by adding the bit
    // above those, towards zero by subtracting the last bit of all, and then clearing the 29 bits. The direction is as
    // good as random from call to call, so it is computed instead of branched upon.
    constexpr auto step = std::uint64_t{1} << 29;
    const bool towards_zero = ((bits ^ std::bit_cast<std::uint64_t>(toward)) & sign) != 0;
    const std::uint64_t moved = bits + (towards_zero ? ~std::uint64_t{0} : step);
    return static_cast<float>(std::bit_cast<double>(moved & ~(step - 1)));
}

/// The first float not below x that is zero or normal; infinite beyond the largest. (With subnormal ones Intel's
/// processors compute some hundred cycles longer. Boxes would have many: what stands on the ground at height 0 ends, by
/// computed bounds, at the smallest number that there is.)
constexpr float rounded_up(double x) {
    constexpr float largest = std::numeric_limits<float>::max(), smallest = std::numeric_limits<float>::min();
    if (x > largest) return std::numeric_limits<float>::infinity();
    if (x < -largest) return -largest;
    if (-smallest < x && x < smallest) return x > 0 ? smallest : 0;
    const auto nearest = static_cast<float>(x);
    return nearest < x ? next_above(nearest) : nearest;
}

}  // namespace raylab
