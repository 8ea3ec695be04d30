#include "raylab/base/small_letters.h"

#include "catch.h"

using namespace raylab;

TEST_CASE("capitals of ASCII alone are made small") {
    CHECK(in_small_letters("") == "");
    CHECK(in_small_letters("AZ az @[`{ 09_Ä") == "az az @[`{ 09_Ä");
}

TEST_CASE("words are equal without regard to ASCII capitals in either, and to nothing else") {
    CHECK(equal_ignoring_case("", ""));
    CHECK(equal_ignoring_case("endSolid", "ENDsolid"));
    CHECK_FALSE(equal_ignoring_case("solid", "solids"));
    CHECK_FALSE(equal_ignoring_case("solids", "solid"));
    CHECK_FALSE(equal_ignoring_case("@[", "`{"));  // 32 apart, as letters are
    CHECK_FALSE(equal_ignoring_case("Ä", "ä"));
}
