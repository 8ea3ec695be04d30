#include "raylab/scene/check_shape.h"

#include "catch.h"

#include <cmath>

using namespace raylab;

TEST_CASE("a hyperboloid may be as wide at its waist as at its ends, not wider") {
    const auto with_waist = [](float waist) { return Hyperboloid{{0, -1, 0}, {0, 1, 0}, waist, 1}; };
    CHECK_NOTHROW(check_shape(with_waist(1), {}));
    CHECK_THROWS_WITH(check_shape(with_waist(std::nextafter(1.0f, 2.0f)), {}),
                      Catch::Contains("at least as wide at its ends"));
}
