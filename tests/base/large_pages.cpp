#include "raylab/base/large_pages.h"

#include "catch.h"

#include <cstdint>
#include <limits>
#include <numeric>

using namespace raylab;

namespace {

struct alignas(64) Line {
    std::uint64_t number = 0;
};

}  // namespace

TEST_CASE("a vector on large pages keeps what it holds as it grows past a large page, aligned") {
    LargeVector<Line> lines;
    for (std::uint64_t i = 0; i < 100'000; ++i) {
        lines.push_back({i});
        REQUIRE(reinterpret_cast<std::uintptr_t>(lines.data()) % alignof(Line) == 0);
    }
    lines.shrink_to_fit();
    for (std::uint64_t i = 0; i < 100'000; ++i) REQUIRE(lines[i].number == i);
}

TEST_CASE("what is larger than a large page begins on one") {
    const LargeVector<char> large(std::size_t{5} << 20);
    CHECK(reinterpret_cast<std::uintptr_t>(large.data()) % large_page == 0);
    CHECK(reinterpret_cast<std::uintptr_t>(large_array<char>(std::size_t{5} << 20).get()) % large_page == 0);
}

TEST_CASE("more elements than there are addresses are refused") {
    CHECK_THROWS_AS(LargePages<Line>().allocate(std::numeric_limits<std::size_t>::max() / 8),
                    std::bad_array_new_length);
    CHECK_THROWS_AS(large_array<int>(std::numeric_limits<std::size_t>::max() / 3), std::bad_array_new_length);
}
