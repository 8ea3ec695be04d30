#include "catch.h"
#include "sanitized.h"

#include "spread.h"

#include "raylab/sampling/mapping/concentric_disk.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

// Points that a function draws are judged by how all of them are spread: right maps pass, a hundredth of a bias fails.

using namespace raylab;
using namespace raylab::grading;

namespace {

constexpr double pi = std::numbers::pi;
constexpr std::uint64_t seeds = is_sanitized ? 2 : 20;
constexpr std::size_t cases_of_exercise = 6;  // as exercise 15b has

using Map = std::function<DrawnShare(double u, double v)>;

Cells cells_of_seed(std::uint64_t seed) { return cells_of(static_cast<double>(seed)); }

std::vector<DrawnShare> drawn_by(const Map& map, std::uint64_t seed) {
    std::vector<DrawnShare> points;
    for (const auto& [u, v] : spread_pairs(seed)) points.push_back(map(u, v));
    return points;
}

// Whether a function that spreads its points by this map fails any of as many cases as an exercise has.
bool is_found(const Map& map, std::uint64_t seed) {
    for (std::size_t i = 0; i < cases_of_exercise; ++i)
        if (uneven_part(drawn_by(map, 999 * seed + i), cells_in_turn(i))) return true;
    return false;
}

struct NamedMap {
    std::string name;
    Map map;
};

DrawnShare of_disk(double x, double y) { return {x * x + y * y, turn_share(x, y)}; }

const std::vector<NamedMap> right_maps{{"polar",
                                        [](double u, double v) {
                                            return DrawnShare{u, v};
                                        }},
                                       {"polar, the other way",
                                        [](double u, double v) {
                                            return DrawnShare{1 - v, std::fmod(u + 0.3, 1)};
                                        }},
                                       {"concentric",
                                        [](double u, double v) {
                                            const auto [x, y] = concentric_disk(u, v);
                                            return of_disk(x, y);
                                        }},
                                       {"all bits mixed", [](double u, double v) {
                                            // As wild as a right map can be: neighbours are not neighbours any more.
                                            return DrawnShare{std::fmod(1000 * u, 1), std::fmod(1000 * v + u, 1)};
                                        }}};

// Each has a density between 0.98 and 1.02 of what it should be, or a hundredth of its points in the wrong place.
const std::vector<NamedMap> biased_maps{
    {"a power of 0.505 for the root",
     [](double u, double v) {
         return DrawnShare{std::pow(u, 1.01), v};
     }},
    {"a radius 1 % too small",
     [](double u, double v) {
         return DrawnShare{0.9801 * u, v};
     }},
    {"a density 1 % higher on one side",
     [](double u, double v) {
         return DrawnShare{u, v - 0.01 * std::sin(2 * pi * v) / (2 * pi)};
     }},
    {"1 % higher on two opposite sides",
     [](double u, double v) {
         return DrawnShare{u, v - 0.01 * std::sin(4 * pi * v) / (4 * pi)};
     }},
    {"1 % higher at a square's four corners",
     [](double u, double v) {
         return DrawnShare{u, v - 0.01 * std::sin(8 * pi * v) / (8 * pi)};
     }},
    {"1 % higher on one side outside, on the other inside",
     [](double u, double v) {
         return DrawnShare{u, v - 0.01 * (2 * u - 1) * std::sin(2 * pi * v) / (2 * pi)};
     }},
    {"an angle that ends at 99 % of the turn",
     [](double u, double v) {
         return DrawnShare{u, 0.99 * v};
     }},
    {"an angle in degrees",
     [](double u, double v) {
         return DrawnShare{u, std::fmod(360 / (2 * pi) * v, 1)};
     }},
    {"one point of a hundred at the centre", [](double u, double v) {
         return DrawnShare{std::fmod(1000 * v, 1) < 0.01 ? 0 : u, v};
     }}};

}  // namespace

TEST_CASE("a right map passes every set of numbers, smooth or wild") {
    for (const auto& [name, map] : right_maps)
        for (std::uint64_t seed = 1; seed <= 10 * seeds; ++seed) {
            INFO(name << ", seed " << seed);
            const auto points = drawn_by(map, seed);
            CHECK_FALSE(uneven_part_of_set(std::span(points).first(pairs_in_set), cells_of_seed(seed)));
            CHECK_FALSE(uneven_part_of_set(std::span(points).subspan(pairs_in_set), cells_of_seed(seed)));
        }
}

TEST_CASE("a bias of 1 % is found wherever it is") {
    for (const auto& [name, map] : biased_maps)
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            INFO(name << ", seed " << seed);
            CHECK(is_found(map, seed));
        }
}

TEST_CASE("whole steps are found down to a hundredth of a degree, and no right map has any, in floats neither") {
    for (std::uint64_t seed = ways_to_cut; seed < ways_to_cut + seeds; ++seed) {
        INFO("seed " << seed);
        for (const double steps : {360.0, 3600.0, 36000.0}) {
            const auto turns = steps_of(drawn_by(
                [=](double u, double v) {
                    return DrawnShare{u, std::floor(steps * v) / steps};
                },
                seed));
            REQUIRE(turns);
            CHECK(turns->of == Steps::Of::turns);
            CHECK(static_cast<double>(turns->values) <= steps);
            const auto insides = steps_of(drawn_by(
                [=](double u, double v) {
                    return DrawnShare{(std::floor(steps * u) + 0.5) / steps, v};
                },
                seed));
            REQUIRE(insides);
            CHECK(insides->of == Steps::Of::insides);
        }
        for (const auto& [name, map] : right_maps) {
            INFO(name);
            CHECK_FALSE(steps_of(drawn_by(map, seed)));
            CHECK_FALSE(steps_of(drawn_by(
                [&](double u, double v) {
                    const auto [inside, turn] = map(static_cast<float>(u), static_cast<float>(v));
                    return DrawnShare{static_cast<float>(inside), static_cast<float>(turn)};
                },
                seed)));
        }
    }
}

TEST_CASE("one set that fails is not enough: a second, independent one has to fail as well") {
    const auto right = drawn_by(right_maps[0].map, 3), wrong = drawn_by(
                                                           [](double u, double) {
                                                               return DrawnShare{u, u};
                                                           },
                                                           2);
    auto points = right;
    std::ranges::copy(std::span(wrong).first(pairs_in_set), points.begin());
    CHECK(uneven_part_of_set(std::span(points).first(pairs_in_set), Cells::squares));
    CHECK_FALSE(uneven_part(points, Cells::squares));
    CHECK(uneven_part(wrong, Cells::squares));
}

TEST_CASE("the part that is told is where the points are") {
    const auto crowded = uneven_part(drawn_by(
                                         [](double u, double v) {
                                             return DrawnShare{u * u, v};
                                         },
                                         3),
                                     Cells::squares);
    REQUIRE(crowded);
    CHECK(crowded->from_inside == 0);
    CHECK(crowded->to_inside == 0.25);
    CHECK(crowded->expected == 0.25);
    CHECK_THAT(crowded->found, WithinAbs(0.5, 0.01));
    const auto half = uneven_part(drawn_by(
                                      [](double u, double v) {
                                          return DrawnShare{u, 0.5 + v / 2};
                                      },
                                      3),
                                  Cells::squares);
    REQUIRE(half);
    CHECK(half->to_inside == 1);
    CHECK(half->expected == 0.125);
    CHECK((half->found == 0 || half->from_turn >= 0.5));
}

TEST_CASE("numbers are in their cells, below 1, and the second set has others") {
    for (const std::uint64_t seed : {3u, 4u, 5u}) {
        const auto numbers = spread_pairs(seed);
        REQUIRE(numbers.size() == pairs);
        const double columns = seed == 3 ? strata : seed == 4 ? cells : 1, rows = cells / columns;
        for (std::size_t i = 0; i < pairs; ++i) {
            const auto cell = static_cast<double>(i % pairs_in_set / 2);
            if (std::floor(numbers[i].u * columns) != std::fmod(cell, columns) ||
                std::floor(numbers[i].v * rows) != std::floor(cell / columns))
                FAIL_CHECK("pair " << i << " is in another cell");
        }
        CHECK(numbers[0].u != numbers[1].u);
        CHECK(numbers[0].u != numbers[pairs_in_set].u);
    }
    const auto at_ends = number_pairs(numbers::at_ends), with_one = number_pairs(numbers::rounded_to_one);
    const auto has = [](const auto& all, double u, double v) {
        return std::ranges::any_of(all, [=](const auto& pair) { return pair.u == u && pair.v == v; });
    };
    for (const double u : {0.0, 0x1p-53, 0.25, 0.5, 1 - 0x1p-53}) CHECK(has(at_ends, u, 0.5));
    CHECK(std::ranges::all_of(at_ends, [](const auto& pair) { return pair.u < 1 && pair.v < 1; }));
    CHECK(has(with_one, 1, 1));
}
