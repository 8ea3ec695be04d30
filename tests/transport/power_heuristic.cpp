#include "catch.h"

#include "raylab/sampling/sequence.h"
#include "raylab/transport/power_heuristic.h"

#include <limits>

using namespace raylab;

TEST_CASE("the power heuristic is a share of squares, and the shares of two strategies sum to one") {
    CHECK(power_heuristic(3, 4) == 9.0 / 25);
    CHECK(power_heuristic(1, 0) == 1);
    CHECK(power_heuristic(2, 2) == 0.5);
    for (std::uint64_t i = 0; i < 1000; ++i) {
        RandomSequence random(79, i);
        const double a = std::exp(random.between(-30, 30)), b = std::exp(random.between(-30, 30));
        CHECK_THAT(power_heuristic(a, b) + power_heuristic(b, a), WithinRel(1, 1e-15));
        CHECK_THAT(power_heuristic(a, b), WithinRel(a * a / (a * a + b * b), 1e-13));
    }
}

TEST_CASE("densities whose squares leave the doubles have weights as well") {
    CHECK(power_heuristic(1e200, 1e200) == 0.5);
    CHECK(power_heuristic(1e-200, 1e-200) == 0.5);
    CHECK_THAT(power_heuristic(3e300, 4e300), WithinRel(0.36, 1e-15));
    CHECK(power_heuristic(1, std::numeric_limits<double>::infinity()) == 0);
    CHECK(power_heuristic(std::numeric_limits<double>::infinity(), 1) == 1);
}
