#include "raylab/experiment/measure/quantile.h"

#include "catch.h"

using namespace raylab;

TEST_CASE("a quantile lies between its neighbours as the share does") {
    const std::vector<double> values{1, 2, 4, 8};
    CHECK(quantile(values, 0) == 1);
    CHECK(quantile(values, 1) == 8);
    CHECK(quantile(values, 0.5) == 3);
    CHECK(quantile(values, 1.0 / 3) == 2);
    CHECK(quantile(values, 0.99) == Approx(7.88));
    CHECK(quantile({5}, 0.99) == 5);
}

TEST_CASE("the median of an even number of values is in the middle of two") {
    CHECK(median({8, 1, 4, 2}) == 3);
    CHECK(median({8, 1, 4}) == 4);
}
