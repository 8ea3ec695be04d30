#include "catch.h"
#include "sampling/cell_counts.h"

#include "raylab/sampling/sampler.h"

#include <cstddef>

using namespace raylab;

namespace {

// Each test below is wrong about a good sampler once in a million: of its two hundred chi-square values none is
// smaller.
constexpr double alpha = 5e-9;
constexpr std::uint64_t seeds = 20'000;

const std::vector<std::string> kinds = sampler_names();

// Whatever a sampler does for one sample after another, over all seeds each of them alone is uniform.
template <class Point>
void check_uniform_over_seeds(const Point& point) {
    for (const auto& kind : kinds)
        for (const int count : {1, 2, 5, 16, 17, 36}) {
            CellCounts cells(8);
            for (std::uint64_t seed = 0; seed < seeds; ++seed)
                cells.add(point(Sampler{.kind = sampler_kind(kind), .count = count, .seed = seed}));
            INFO(kind << ", " << count << " samples");
            CHECK(cells.p_value() > alpha);
        }
}

SamplePlace last_of(const Sampler& sampler) { return {.pixel = 7, .x = 3, .y = 5, .index = sampler.count - 1}; }

}  // namespace

TEST_CASE("a sample of any sampler, of any count, is uniform in the square") {
    check_uniform_over_seeds([](const Sampler& sampler) { return pair(sampler, last_of(sampler), 2); });
}

TEST_CASE("the numbers of different purposes are independent, and so are pair and number of the same") {
    check_uniform_over_seeds([](const Sampler& sampler) -> std::array<double, 2> {
        return {pair(sampler, last_of(sampler), 2)[1], pair(sampler, last_of(sampler), 3)[1]};
    });
    check_uniform_over_seeds([](const Sampler& sampler) -> std::array<double, 2> {
        return {number(sampler, last_of(sampler), 2), number(sampler, last_of(sampler), 3)};
    });
    check_uniform_over_seeds([](const Sampler& sampler) -> std::array<double, 2> {
        return {pair(sampler, last_of(sampler), 2)[0], number(sampler, last_of(sampler), 2)};
    });
}

TEST_CASE("within one pixel, too: purposes meet in another order, so their samples fill the square together") {
    for (const auto& kind : kinds) {
        const Sampler sampler{.kind = sampler_kind(kind), .count = 4096, .seed = 5};
        CellCounts cells(8);
        for (int i = 0; i < sampler.count; ++i) {
            const SamplePlace place{.pixel = 9, .x = 1, .y = 2, .index = i};
            cells.add(pair(sampler, place, 0)[0], pair(sampler, place, 7)[0]);
        }
        INFO(kind);
        CHECK(cells.p_value() > alpha);
    }
}

TEST_CASE("pixels are independent of one another, except where a mask makes them differ") {
    for (const auto& kind : kinds) {
        CellCounts cells(8);
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
            const Sampler sampler{.kind = sampler_kind(kind), .count = 16, .seed = seed};
            cells.add(pair(sampler, {.pixel = 1, .x = 1, .y = 0, .index = 3}, 0)[0],
                      pair(sampler, {.pixel = 2, .x = 2, .y = 0, .index = 3}, 0)[0]);
        }
        INFO(kind);
        CHECK((cells.p_value() > alpha) == (kind != "blue_noise"));
    }
}

TEST_CASE("numbers lie in [0, 1), and the same place and purpose have the same") {
    for (const auto& kind : kinds)
        for (const int count : {1, 3, 1000, 2'000'000'000}) {
            const Sampler sampler{.kind = sampler_kind(kind), .count = count};
            for (std::uint64_t pixel = 0; pixel < 500; ++pixel) {
                const SamplePlace place{.pixel = pixel, .index = count - 1};
                const auto [x, y] = pair(sampler, place, 4);
                const double z = number(sampler, place, 4);
                INFO(kind << ": " << x << " " << y << " " << z);
                CHECK((x >= 0 && x < 1 && y >= 0 && y < 1 && z >= 0 && z < 1));
                CHECK(pair(sampler, place, 4) == std::array{x, y});
            }
        }
}

TEST_CASE("samplers have names, and a wrong one is told the nearest") {
    for (const auto& name : kinds) CHECK(to_string(sampler_kind(name)) == name);
    CHECK_THROWS_WITH(sampler_kind("soboll"), Catch::Contains("found \"soboll\" (did you mean \"sobol\"?)"));
}
