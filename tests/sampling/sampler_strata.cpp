#include "catch.h"
#include "sampling/cell_counts.h"

#include "raylab/sampling/pattern/halton.h"
#include "raylab/sampling/pattern/permuted_index.h"
#include "raylab/sampling/pattern/sobol.h"
#include "raylab/sampling/random.h"
#include "raylab/sampling/sampler.h"

#include <algorithm>
#include <cmath>

using namespace raylab;

namespace {

using Points = std::vector<std::array<double, 2>>;

Points points(SamplerKind kind, int count, int purpose) {
    Points all;
    for (int i = 0; i < count; ++i)
        all.push_back(pair({.kind = kind, .count = count}, {.pixel = 11, .index = i}, purpose));
    return all;
}

// Whether each of columns x rows equal cells has exactly one of the points.
bool one_in_each(const Points& points, int columns, int rows) {
    std::vector<int> counts(static_cast<std::size_t>(columns * rows));
    for (const auto& [x, y] : points)
        ++counts[static_cast<std::size_t>(static_cast<int>(y * rows) * columns + static_cast<int>(x * columns))];
    return std::ranges::all_of(counts, [](int count) { return count == 1; });
}

}  // namespace

TEST_CASE("the first points of Sobol's sequence are the published ones") {
    // In the order of Gray's code, as programs print them: Joe and Kuo's, the first two dimensions.
    constexpr std::array<std::array<double, 2>, 10> published{{{0, 0},
                                                               {0.5, 0.5},
                                                               {0.75, 0.25},
                                                               {0.25, 0.75},
                                                               {0.375, 0.375},
                                                               {0.875, 0.875},
                                                               {0.625, 0.125},
                                                               {0.125, 0.625},
                                                               {0.1875, 0.3125},
                                                               {0.6875, 0.8125}}};
    for (std::uint32_t i = 0; i < published.size(); ++i) {
        const std::uint32_t index = i ^ (i >> 1);
        CHECK(reversed_bits(reversed_sobol_x(index)) * 0x1p-32 == published[i][0]);
        CHECK(reversed_bits(reversed_sobol_y(index)) * 0x1p-32 == published[i][1]);
    }
}

TEST_CASE("scrambled and shuffled, 64 of Sobol's points still have one in each cell of every kind of division") {
    for (int purpose = 0; purpose < 50; ++purpose)
        for (int columns = 1; columns <= 64; columns *= 2)
            CHECK(one_in_each(points(SamplerKind::sobol, 64, purpose), columns, 64 / columns));
}

TEST_CASE("Halton's points have one in each cell of 8 x 9, 4 x 3 and 1 x 27") {
    for (int purpose = 0; purpose < 50; ++purpose) {
        CHECK(one_in_each(points(SamplerKind::halton, 72, purpose), 8, 9));
        CHECK(one_in_each(points(SamplerKind::halton, 12, purpose), 4, 3));
        CHECK(one_in_each(points(SamplerKind::halton, 27, purpose), 1, 27));
    }
}

TEST_CASE("jittered samples have one in each cell; n-rooks in each row and column; multi-jittered do both") {
    for (int purpose = 0; purpose < 50; ++purpose)
        for (const int side : {1, 2, 3, 4, 5, 8}) {
            const int count = side * side;
            CHECK(one_in_each(points(SamplerKind::jittered, count, purpose), side, side));
            for (const SamplerKind kind : {SamplerKind::n_rooks, SamplerKind::multi_jittered}) {
                CHECK(one_in_each(points(kind, count, purpose), count, 1));
                CHECK(one_in_each(points(kind, count, purpose), 1, count));
            }
            CHECK(one_in_each(points(SamplerKind::multi_jittered, count, purpose), side, side));
        }
}

TEST_CASE("a count that is no square divides the square into cells of equal area as well") {
    // 7 samples are rows of 3, 2 and 2: the first row is three sevenths high.
    for (int purpose = 0; purpose < 50; ++purpose) {
        const Points seven = points(SamplerKind::jittered, 7, purpose);
        Points first_row, others;
        for (const auto& [x, y] : seven) {
            if (y < 3.0 / 7)
                first_row.push_back({x, y * 7 / 3});
            else
                others.push_back({x, (y - 3.0 / 7) * 7 / 4});
        }
        CHECK(first_row.size() == 3);
        CHECK((one_in_each(first_row, 3, 1) && one_in_each(others, 2, 2)));
    }
    for (int count = 1; count < 40; ++count) {
        CHECK(one_in_each(points(SamplerKind::n_rooks, count, 1), count, 1));
        CHECK(one_in_each(points(SamplerKind::multi_jittered, count, 1), 1, count));
    }
}

TEST_CASE("in one dimension jittered numbers have one in each of any number of intervals") {
    for (const SamplerKind kind : {SamplerKind::jittered, SamplerKind::multi_jittered, SamplerKind::n_rooks})
        for (int count = 1; count < 40; ++count) {
            Points all;
            for (int i = 0; i < count; ++i) all.push_back({number({.kind = kind, .count = count}, {.index = i}, 3), 0});
            CHECK(one_in_each(all, count, 1));
        }
}

TEST_CASE("a permuted index is a permutation, and two indices go to any two places equally often, to 3 %") {
    for (std::uint32_t count = 1; count < 200; ++count) {
        std::vector<bool> seen(count);
        for (std::uint32_t i = 0; i < count; ++i) seen[permuted_index(i, count, mixed(count))] = true;
        CHECK(std::ranges::all_of(seen, [](bool was) { return was; }));
    }
    for (const std::uint32_t count : {2u, 3u, 4u, 5u, 8u, 9u, 16u, 25u}) {
        constexpr std::uint64_t trials = 1'000'000;
        std::vector<double> pairs(count * (count - 1));
        for (std::uint64_t key = 0; key < trials; ++key) {
            const std::uint32_t a = permuted_index(0, count, mixed(key)), b = permuted_index(1, count, mixed(key));
            ++pairs[a * (count - 1) + (b > a ? b - 1 : b)];
        }
        const double cells = count * (count - 1), expected = static_cast<double>(trials) / cells;
        double squares = 0;
        for (const double pair : pairs) squares += std::pow(pair / expected - 1, 2) / cells;
        INFO(count << ": root mean square " << std::sqrt(squares));
        CHECK(squares - 1 / expected < 0.03 * 0.03);  // without what chance adds
    }
}

TEST_CASE("Halton's coordinates are the digits read backwards, and those of large primes step together") {
    CHECK(radical_inverse(2, 6) == 0.375);                         // 110
    CHECK_THAT(radical_inverse(3, 5), WithinRel(7.0 / 9, 1e-15));  // 12
    for (std::uint32_t i = 0; i < 29; ++i)
        CHECK(std::abs(radical_inverse(29, i) - radical_inverse(31, i)) < 0.07);  // the first points of a 10-d sequence
    CellCounts cells(3);  // the fourteenth purpose of the sampler, which uses no more primes than the first
    for (const auto& point : points(SamplerKind::halton, 29, 14)) cells.add(point);
    CHECK(std::ranges::all_of(cells.counts(), [](std::uint64_t count) { return count >= 2 && count <= 5; }));
}
