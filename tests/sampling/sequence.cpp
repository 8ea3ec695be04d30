#include "catch.h"

#include "raylab/sampling/sequence.h"

#include <array>

using namespace raylab;

TEST_CASE("a sequence is the dimensions of its place") {
    RandomSequence sequence(5, 17, 2);
    for (std::uint64_t dimension = 0; dimension < 4; ++dimension)
        CHECK(sequence.next() == random_number({5, 17, 2, dimension}));
}

TEST_CASE("a unit vector across an axis is at right angles to it") {
    for (std::uint64_t i = 0; i < 100; ++i) {
        RandomSequence random(3, i);
        const Vec3d axis = random.unit_vector() * 5.0;
        const Vec3d v = random.unit_vector_across(axis);
        CHECK_THAT(dot(v, axis), WithinAbs(0, 1e-12));
        CHECK_THAT(glm::length(v), WithinAbs(1, 1e-12));
    }
}

TEST_CASE("a copy of a sequence goes on from where it was taken") {
    RandomSequence sequence(5, 17);
    sequence.next();
    RandomSequence copy = sequence;
    CHECK(copy.next() == sequence.next());
}

TEST_CASE("whole numbers take each value between their ends alike") {
    std::array<int, 5> counts{};
    for (std::uint64_t i = 0; i < 5000; ++i) ++counts[static_cast<std::size_t>(RandomSequence(1, i).whole(-2, 2) + 2)];
    for (const int count : counts) CHECK(std::abs(count - 1000) < 150);  // more than five standard deviations
}

TEST_CASE("unit vectors are of length one and lean no way") {
    Vec3d sum{0, 0, 0};
    constexpr int count = 30000;
    for (std::uint64_t i = 0; i < count; ++i) {
        const Vec3d v = RandomSequence(2, i).unit_vector();
        REQUIRE_THAT(glm::length(v), WithinAbs(1, 1e-12));
        sum += v;
    }
    CHECK(glm::length(sum) < 5 * std::sqrt(double(count)));  // a random walk of `count` unit steps
}
