#include "catch.h"

#include "raylab/sampling/chi_square.h"

#include <array>

using namespace raylab;

TEST_CASE("the tail of the chi-square distribution, in closed form and from tables") {
    CHECK(chi_square_tail(0, 3) == 1);
    for (const double x : {0.01, 1.0, 5.0, 40.0, 200.0}) {
        CHECK_THAT(chi_square_tail(x, 2), WithinRel(std::exp(-x / 2), 1e-13));
        CHECK_THAT(chi_square_tail(x, 4), WithinRel(std::exp(-x / 2) * (1 + x / 2), 1e-13));
        CHECK_THAT(chi_square_tail(x, 1), WithinRel(std::erfc(std::sqrt(x / 2)), 1e-12));
    }
    CHECK_THAT(chi_square_tail(18.307, 10), WithinAbs(0.05, 1e-5));
    CHECK_THAT(chi_square_tail(135.807, 100), WithinAbs(0.01, 1e-5));
}

TEST_CASE("cells that expect fewer than five are one cell, and what cannot happen must not") {
    const std::array<std::uint64_t, 4> counts{10, 12, 3, 0};
    const std::array<double, 4> expected{11, 11, 2, 1};
    CHECK_THAT(chi_square_p_value(counts, expected), WithinRel(chi_square_tail(2.0 / 11, 2), 1e-12));
    CHECK(chi_square_p_value(counts, std::array<double, 4>{13, 12, 0, 0}) == 0);
    CHECK_THAT(chi_square_p_value(std::array<std::uint64_t, 2>{60, 40}), WithinRel(chi_square_tail(4, 1), 1e-12));
}
