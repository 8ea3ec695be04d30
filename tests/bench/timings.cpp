#include "timings.h"

#include "catch.h"

#include <initializer_list>
#include <optional>

using namespace raylab::bench;

namespace {

Timings timings(std::optional<int> processor, std::initializer_list<double> seconds) {
    Timings all;
    for (const double one : seconds) all.add(processor, one);
    return all;
}

}  // namespace

TEST_CASE("what ran anywhere took its median") {
    const Timings all = timings({}, {9, 1, 2, 3, 4});
    CHECK(all.typical() == 3);
    CHECK(all.shortest() == 1);
    CHECK(all.longest() == 9);
}

TEST_CASE("what took processors in turns took as long as at the mean of their speeds") {
    Timings all = timings(0, {2, 2, 50});
    for (const double one : {6.0, 1.0, 6.0}) all.add(1, one);
    CHECK(all.typical() == 3);  // of 1/2 and 1/6 a second
    CHECK(all.shortest() == 1);
    CHECK(all.longest() == 50);
}
