#include "catch.h"

#include "raylab/sampling/random.h"

#include <array>
#include <set>

using namespace raylab;

TEST_CASE("a place has one random number, and another place another") {
    constexpr RandomPlace place{.seed = 1, .pixel = 2, .sample = 3, .dimension = 4};
    static_assert(random_number(place) == random_number(place));
    std::set<double> numbers = {random_number(place)};
    for (const RandomPlace& other : {RandomPlace{2, 2, 3, 4}, {1, 3, 3, 4}, {1, 2, 4, 4}, {1, 2, 3, 5}, {2, 1, 3, 4}})
        numbers.insert(random_number(other));
    CHECK(numbers.size() == 6);
}

TEST_CASE("random numbers fill [0, 1) evenly along every coordinate of a place") {
    // Chi-squared over 64 cells: 63 degrees of freedom, 131 is exceeded with probability 1e-6.
    constexpr int count = 64 * 1000;
    for (int coordinate = 0; coordinate < 4; ++coordinate) {
        std::array<int, 64> cells{};
        for (int i = 0; i < count; ++i) {
            std::array<std::uint64_t, 4> place{7, 7, 7, 7};
            place[static_cast<std::size_t>(coordinate)] = static_cast<std::uint64_t>(i);
            ++cells[static_cast<std::size_t>(random_number({place[0], place[1], place[2], place[3]}) * 64)];
        }
        double chi_squared = 0;
        for (const int cell : cells) chi_squared += (cell - 1000.0) * (cell - 1000.0) / 1000.0;
        INFO("coordinate " << coordinate);
        CHECK(chi_squared < 131);
        CHECK(chi_squared > 20);  // a distribution that is too even would be no accident either
    }
}

TEST_CASE("neighbouring dimensions, samples and pixels are not related") {
    // Pairs (x, y) over 8 x 8 cells: 63 degrees of freedom.
    constexpr int count = 64 * 1000;
    for (const RandomPlace& step : {RandomPlace{0, 0, 0, 1}, {0, 0, 1, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}}) {
        std::array<int, 64> cells{};
        for (std::uint64_t i = 0; i < count; ++i) {
            const RandomPlace one{3 + i % 5, i, i % 7, i % 3};
            const RandomPlace other{one.seed + step.seed, one.pixel + step.pixel, one.sample + step.sample,
                                    one.dimension + step.dimension};
            const int column = static_cast<int>(random_number(one) * 8);
            const int row = static_cast<int>(random_number(other) * 8);
            ++cells[static_cast<std::size_t>(8 * row + column)];
        }
        double chi_squared = 0;
        for (const int cell : cells) chi_squared += (cell - 1000.0) * (cell - 1000.0) / 1000.0;
        CHECK(chi_squared < 131);
    }
}
