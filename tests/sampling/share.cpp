#include "catch.h"

#include "raylab/sampling/random.h"
#include "raylab/sampling/share.h"

using namespace raylab;

TEST_CASE("Wilson's interval has the values of its formula") {
    // 10 of 100, 95 %: 0.05523 to 0.17437 (Newcombe, Statistics in Medicine 17, 1998, method 3, recomputed).
    const Share share = share_of(10, 100);
    CHECK(share.value() == 0.1);
    CHECK_THAT(share.low, WithinAbs(0.0552291, 1e-6));
    CHECK_THAT(share.high, WithinAbs(0.1743657, 1e-6));
}

TEST_CASE("nothing in n trials leaves room for about 3.8 / n") {
    const Share none = share_of(0, 1000000);
    CHECK(none.low == 0);
    CHECK_THAT(none.high, WithinRel(3.8415e-6, 1e-3));
    CHECK(share_of(50, 50).high == 1);
    CHECK(share_of(50, 50).low < 1);
}

TEST_CASE("the interval holds the truth in about 95 of 100 experiments") {
    int held = 0;
    constexpr int experiments = 2000;
    for (std::uint64_t e = 0; e < experiments; ++e) {
        std::uint64_t happened = 0;
        for (std::uint64_t t = 0; t < 500; ++t) happened += random_number({.seed = 11, .pixel = e, .sample = t}) < 0.03;
        const Share share = share_of(happened, 500);
        held += share.low <= 0.03 && 0.03 <= share.high;
    }
    CHECK(held > 0.93 * experiments);
    CHECK(held < 0.98 * experiments);
}
