#include "catch.h"

#include "raylab/geometry/oracle/oracle.h"

#include <cmath>
#include <limits>

using namespace raylab;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The exact quotient of two doubles: where a ray along x hits a triangle across it.
oracle::ExactT quotient(double numerator, double denominator) {
    const TriangleOf<double> across{{numerator, -1, -1}, {numerator, 1, -1}, {numerator, 0, 2}};
    return oracle::intersect(RayOf<double>{{0, 0, 0}, {denominator, 0, 0}, {-infinity, infinity}}, across).t.value();
}

/// x^2 + 1 + 1 = 4: where a ray leaves a sphere of radius 2.
oracle::ExactT root_of_two() {
    const SphereOf<double> sphere{{0, 0, 0}, 2};
    return oracle::intersect(RayOf<double>{{0, 1, 1}, {1, 0, 0}, {0, infinity}}, sphere).t.value();
}

}  // namespace

TEST_CASE("exact t: the nearest double is the machine's correctly rounded quotient, subnormals included") {
    for (const double numerator : {1.0, -1.0, 7.0, 1e300, 3e-300, 0x1.fffffffffffffp+0, 0.0})
        for (const double denominator : {3.0, -7.0, 1e8, 1e-8, 0x1.0000000000001p+0, 1e20}) {
            const volatile double n = numerator;  // divided when the program runs, to nearest
            CHECK(quotient(numerator, denominator).nearest() == n / denominator);
        }
}

TEST_CASE("exact t: too large for a double is infinity, and still ordered below it") {
    const auto huge = quotient(1e300, 1e-300);
    CHECK(huge.nearest() == infinity);
    CHECK(is_lt(huge.compare(infinity)));
    CHECK(is_gt(huge.compare(std::numeric_limits<double>::max())));
    CHECK(is_gt(quotient(-1e300, 1e-300).compare(-infinity)));
}

TEST_CASE("exact t: half-way between two subnormals rounds to even") {
    constexpr double smallest = std::numeric_limits<double>::denorm_min();
    CHECK(quotient(smallest, 2.0).nearest() == 0.0);
    CHECK(quotient(3 * smallest, 2.0).nearest() == 2 * smallest);
    CHECK(quotient(5 * smallest, 2.0).nearest() == 2 * smallest);
    CHECK(quotient(-3 * smallest, 2.0).nearest() == -2 * smallest);
}

TEST_CASE("exact t: the nearest double of a square root is the machine's") {
    const volatile double two = 2;
    CHECK(root_of_two().nearest() == std::sqrt(two));
}

TEST_CASE("exact t: errors are counted in units of the last place of the nearest float") {
    const auto one = quotient(1.0, 1.0);
    CHECK(one.error_in_ulp(1.0f) == 0);
    CHECK(one.error_in_ulp(std::nextafter(1.0f, 2.0f)) == 1);
    CHECK(one.error_in_ulp(std::nextafter(1.0f, 0.0f)) == 0.5);
    CHECK(one.error_in_ulp(std::nextafter(1.0, 2.0)) == 1);
    CHECK(one.error_in_ulp(infinity) == infinity);
    CHECK(one.error_in_ulp(std::numeric_limits<double>::quiet_NaN()) == infinity);
    CHECK_THAT(quotient(1.0, 3.0).error_in_ulp(1.0f / 3.0f), WithinRel(1.0 / 3.0, 1e-15));
    // (sqrt(2) - 1.41421354f) 2^23 and (1.4142135623730951 - sqrt(2)) 2^52, worked out to forty digits
    CHECK_THAT(root_of_two().error_in_ulp(1.41421354f), WithinAbs(0.20303144411, 1e-11));
    CHECK_THAT(root_of_two().error_in_ulp(std::sqrt(2.0)), WithinAbs(0.43537618564, 1e-11));
}

TEST_CASE("exact t: zero is measured in the smallest subnormal") {
    CHECK(quotient(0.0, 1.0).error_in_ulp(0.0f) == 0);
    CHECK(quotient(0.0, 1.0).error_in_ulp(std::numeric_limits<float>::denorm_min()) == 1);
}

TEST_CASE("exact t: is written as a decimal and what it is exactly") {
    CHECK(quotient(2.0, 1.0).to_string() == "2");
    CHECK(quotient(3.0, 4.0).to_string() == "0.75 (3/4)");
    CHECK(root_of_two().to_string() == "1.4142135623730951 (larger root of t^2 - 2)");
    CHECK(quotient(1e300, 3e-20).to_string().find("digits") != std::string::npos);
}

TEST_CASE("exact t: a root that is a fraction is written as one") {
    // t^2 / 4 - 3 t + 35/4 = 0 at 5 and 7
    const RayOf<double> ray{{-3, 0, 0}, {0.5, 0, 0}, {0, infinity}};
    CHECK(oracle::intersect(ray, SphereOf<double>{{0, 0, 0}, 0.5}).t.value().to_string() == "5");
}
