#include "catch.h"

#include "raylab/number/scalar.h"

#include <array>
#include <string>

using namespace raylab;

namespace {

// A function with two numbers at once, in which GCC 12 lost the rounding.
[[gnu::noinline]] void pass_through_float(std::array<double, 2>& numbers) {
    const float first = cast<float>(numbers[0]), second = cast<float>(numbers[1]);
    numbers[0] = first;
    numbers[1] = second;
}

}  // namespace

TEST_CASE("numbers rounded to float and widened again have been rounded") {
    const volatile double one = 1;  // so that nothing can be computed at compile time
    std::array<double, 2> numbers = {one / 3, one / 7};
    pass_through_float(numbers);
    CHECK(numbers[0] == 0x1.555556p-2);
    CHECK(numbers[1] == 0x1.24924ap-3);
}

TEST_CASE("a number type is named as tables have it") {
    CHECK(number_name<float> == std::string("float"));
    CHECK(number_name<double> == std::string("double"));
    CHECK(number_name<long double> == std::string("long double"));
}
