#include "catch.h"
#include "sampling/cell_counts.h"

#include "raylab/sampling/pattern/sobol.h"
#include "raylab/sampling/sampler.h"

#include <cmath>

// Two purposes whose pairs are one sequence of four dimensions (Sampler::beside_first).

using namespace raylab;

namespace {

constexpr int beside = 4;

struct FourNumbers {
    std::array<double, 2> first, second;
};

FourNumbers numbers(Sampler sampler, std::uint64_t pixel, int index) {
    const SamplePlace place{.pixel = pixel, .index = index};
    return {pair(sampler, place, 0), pair(sampler, place, beside)};
}

// The fewest and the most of 64 points in a cell of any division into 2^a columns, 2^b rows, and so on: 8 cells in all.
std::array<int, 2> extremes(int beside_first) {
    std::array<int, 2> found{64, 0};
    for (std::uint64_t pixel = 0; pixel < 20; ++pixel)
        for (int a = 0; a <= 3; ++a)
            for (int b = 0; a + b <= 3; ++b)
                for (int c = 0; a + b + c <= 3; ++c) {
                    std::array<int, 8> counts{};
                    for (int i = 0; i < 64; ++i) {
                        const auto [first, second] = numbers({.count = 64, .beside_first = beside_first}, pixel, i);
                        int cell = 0;
                        const auto divide = [&](double x, int halvings) {
                            cell = (cell << halvings) + static_cast<int>(std::ldexp(x, halvings));
                        };
                        divide(first[0], a), divide(first[1], b), divide(second[0], c),
                            divide(second[1], 3 - a - b - c);
                        ++counts[static_cast<std::size_t>(cell)];
                    }
                    for (const int count : counts) found = {std::min(found[0], count), std::max(found[1], count)};
                }
    return found;
}

// An edge that two effects blur equally, each in one of its two numbers.
double edge_error(const Sampler& sampler) {
    constexpr std::uint64_t pixels = 200;
    double squares = 0;
    for (std::uint64_t pixel = 0; pixel < pixels; ++pixel) {
        double inside = 0;
        for (int i = 0; i < sampler.count; ++i) {
            const auto [first, second] = numbers(sampler, pixel, i);
            inside += first[0] + second[0] < 1 ? 1 : 0;
        }
        squares += std::pow(inside / sampler.count - 0.5, 2);
    }
    return std::sqrt(squares / pixels);
}

double edge_slope(int beside_first) {
    const auto error = [&](int count) { return edge_error({.count = count, .beside_first = beside_first}); };
    return std::log(error(4096) / error(16)) / std::log(256);
}

}  // namespace

TEST_CASE("the third and fourth coordinate of Sobol's sequence begin as published") {
    // In the order of Gray's code, as programs print them: Joe and Kuo's numbers.
    constexpr std::array<std::array<double, 2>, 10> published{{{0, 0},
                                                               {0.5, 0.5},
                                                               {0.25, 0.25},
                                                               {0.75, 0.75},
                                                               {0.625, 0.875},
                                                               {0.125, 0.375},
                                                               {0.875, 0.625},
                                                               {0.375, 0.125},
                                                               {0.9375, 0.4375},
                                                               {0.4375, 0.9375}}};
    for (std::uint32_t i = 0; i < published.size(); ++i) {
        const std::uint32_t index = i ^ (i >> 1);
        CHECK(reversed_bits(third_sobol.reversed(index)) * 0x1p-32 == published[i][0]);
        CHECK(reversed_bits(fourth_sobol.reversed(index)) * 0x1p-32 == published[i][1]);
    }
}

// The sum of the polynomials' degrees, less one each, is 3: 64 points have 8 in each cell of an eighth (Sobol 1967).
TEST_CASE("64 points of four dimensions have eight in each eighth of every kind of division; two pairs have not") {
    CHECK(extremes(beside) == std::array{8, 8});
    CHECK(extremes(Sampler::none) != std::array{8, 8});
}

TEST_CASE("an edge that two effects blur: pairs that meet in any order err as N^-1/2, one sequence as N^-3/4") {
    CHECK_THAT(edge_slope(Sampler::none), WithinAbs(-0.5, 0.08));
    CHECK_THAT(edge_slope(beside), WithinAbs(-0.75, 0.08));
}

TEST_CASE("each sample of the four numbers is uniform, and the two pairs of a sample are independent") {
    for (const int count : {1, 2, 5, 16, 17}) {
        CellCounts second(8), across(8), across_others(8);
        for (std::uint64_t seed = 0; seed < 20'000; ++seed) {
            const auto [a, b] = numbers({.count = count, .seed = seed, .beside_first = beside}, 7, count - 1);
            second.add(b);
            across.add(a[0], b[0]);
            across_others.add(a[1], b[1]);
        }
        INFO(count << " samples");
        constexpr double alpha = 5e-9;  // wrong about a good sampler once in ten million runs
        CHECK((second.p_value() > alpha && across.p_value() > alpha && across_others.p_value() > alpha));
    }
}
