#include "catch.h"

#include "raylab/number/next_float.h"
#include "raylab/sampling/random.h"

#include <cmath>

using namespace raylab;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// The next float by the standard library's step, from the nearest float.
float beyond(double x, double toward) {
    const auto nearest = static_cast<float>(x);
    const bool is_there = toward > 0 ? nearest > x : nearest < x;
    return is_there ? nearest : std::nextafter(nearest, toward > 0 ? infinity : -infinity);
}

bool is_right(double x) { return float_beyond(x, 1) == beyond(x, 1) && float_beyond(x, -1e-300) == beyond(x, -1); }

}  // namespace

TEST_CASE("the first float beyond a number is the next one, and the nearest if that lies there") {
    constexpr double smallest = std::numeric_limits<float>::min(), tiniest = std::numeric_limits<float>::denorm_min();
    for (const double x : {0.0, tiniest / 3, tiniest, smallest, 2 * smallest, 1.0, 3e38})
        for (const double near : {std::nextafter(x, -1e39), x, std::nextafter(x, 1e39)})
            CHECK((is_right(near) && is_right(-near)));
    int wrong = 0;
    for (std::uint64_t i = 0; i < 100'000; ++i) {
        const auto mantissa = static_cast<std::int64_t>(random_bits({.pixel = i}));
        const auto exponent = static_cast<int>(random_bits({.pixel = i, .dimension = 1}) % 276) - 213;
        const double x = std::ldexp(static_cast<double>(mantissa), exponent);
        wrong += is_right(x) ? 0 : 1;
    }
    CHECK(wrong == 0);
}

TEST_CASE("a number is rounded up to the first float not below it that is zero or normal") {
    constexpr double smallest = std::numeric_limits<float>::min(), tiniest = std::numeric_limits<float>::denorm_min(),
                     largest = std::numeric_limits<float>::max();
    CHECK(rounded_up(0) == 0);
    CHECK(rounded_up(std::numeric_limits<double>::denorm_min()) == smallest);
    CHECK((rounded_up(tiniest) == smallest && rounded_up(-tiniest) == 0));
    CHECK((rounded_up(smallest) == smallest && rounded_up(-smallest) == -smallest));
    CHECK(rounded_up(std::nextafter(smallest, 1)) == smallest + tiniest);
    CHECK(rounded_up(std::nextafter(-smallest, 0)) == 0);
    CHECK((rounded_up(largest) == largest && rounded_up(-2 * largest) == -largest));
    CHECK(rounded_up(std::nextafter(largest, 1e39)) == infinity);
    for (const double x : {1.0, 0.1, 1e-37, 3e38})
        for (const double near : {std::nextafter(x, 0), x, std::nextafter(x, 1e39)})
            for (const double signed_one : {near, -near}) {
                const float up = rounded_up(signed_one);
                CHECK((up >= signed_one && std::nextafter(up, -infinity) < signed_one));
            }
}
