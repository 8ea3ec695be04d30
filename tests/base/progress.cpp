#include "raylab/base/progress.h"

#include "catch.h"

using namespace raylab;

TEST_CASE("the time left is as long for each share as what is done took") {
    CHECK(time_left(10, 0.5) == ", 10 s left");
    CHECK(time_left(30, 0.25) == ", 90 s left");
    CHECK(time_left(60, 0.25) == ", 3 min left");
    CHECK(time_left(3600, 0.25) == ", 3 h left");
    CHECK(time_left(10, 0.95).empty());
    CHECK(time_left(10, 1).empty());
    CHECK(time_left(10, 0).empty());
}
