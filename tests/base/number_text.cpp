#include "raylab/base/number_text.h"

#include "catch.h"

using namespace raylab;

TEST_CASE("numbers for people have three digits and a unit that fits") {
    CHECK(number_text(0) == "0");
    CHECK(number_text(12.345) == "12.3");
    CHECK(number_text(999.6) == "1 000");
    CHECK(number_text(123456.7) == "123 457");
    CHECK(number_text(-1234) == "-1 234");
    CHECK(number_text(1.5e7) == "1.5·10⁷");
    CHECK(number_text(1e-5) == "1·10⁻⁵");
    CHECK(number_text(1.234e-12) == "1.23·10⁻¹²");
    CHECK(duration_text(12.34) == "12.3 ns");
    CHECK(duration_text(2.5e9) == "2.5 s");
    CHECK(duration_text(0.5) == "0.5 ns");
    CHECK(count_text(7) == "7");
    CHECK(count_text(2'000'000) == "2 000 000");
}

TEST_CASE("a share is a percentage, below a hundredth of a per cent parts per million, and 100 % only if it is all") {
    CHECK(share_text(0) == "0");
    CHECK(share_text(4e-7) == "0.4 ppm");
    CHECK(share_text(12.4e-6) == "12 ppm");
    CHECK(share_text(99e-6) == "99 ppm");
    CHECK(share_text(1e-4) == "0.01 %");
    CHECK(share_text(3.42e-4) == "0.034 %");
    CHECK(share_text(0.034) == "3.4 %");
    CHECK(share_text(0.0996) == "10 %");
    CHECK(share_text(0.811) == "81 %");
    CHECK(share_text(0.994) == "99 %");
    CHECK(share_text(0.995) == "99.5 %");
    CHECK(share_text(0.9951) == "99.5 %");
    CHECK(share_text(0.9976) == "99.8 %");
    CHECK(share_text(0.99999) == "99.9 %");
    CHECK(share_text(1) == "100 %");
}

TEST_CASE("a ratio has two digits, and two behind the point where it is nearly one") {
    CHECK(ratio_text(1.049) == "1.05 ×");
    CHECK(ratio_text(6.12) == "6.1 ×");
    CHECK(ratio_text(9.96) == "10 ×");
    CHECK(ratio_text(44.4) == "44 ×");
    CHECK(ratio_text(1234) == "1 200 ×");
}
