#include "catch.h"

#include "raylab/geometry/affine.h"
#include "raylab/sampling/sequence.h"

#include <cmath>

using namespace raylab;

namespace {

Affine linear(Vec3f a, Vec3f b, Vec3f c) { return {{a, b, c}, {1, 2, 3}}; }

}  // namespace

TEST_CASE("a rotation, a mirror and a tiny scale can be undone") {
    CHECK_FALSE(is_singular(AffineSteps::rotate({1, 2, 3}, 33).rounded()));
    CHECK_FALSE(is_singular(AffineSteps::scale({-1, 1, 1}).rounded()));
    CHECK_FALSE(is_singular(AffineSteps::scale({1e-40, 1e-40, 1e-40}).rounded()));
    CHECK_FALSE(is_singular(AffineSteps::scale({1e38, 1e-38, 1e38}).rounded()));
}

TEST_CASE("a map that flattens space is singular, also where rounding hides it") {
    CHECK(is_singular(AffineSteps::scale({1, 0, 1}).rounded()));
    CHECK(is_singular(linear({1, 2, 3}, {4, 5, 6}, {7, 8, 9})));
    CHECK(is_singular(linear({0.1f, 0.2f, 0.3f}, {0.7f, 0.1f, 0.9f}, {0.2f, 0.4f, 0.6f})));
    CHECK(is_singular(linear({0, 0, 0}, {0, 0, 0}, {0, 0, 0})));
}

TEST_CASE("one unit in the last place away from a singular map, the map can be undone") {
    CHECK_FALSE(is_singular(linear({1, 2, 3}, {4, 5, 6}, {7, 8, std::nextafter(9.0f, 10.0f)})));
    CHECK_FALSE(is_singular(linear({0.1f, 0.2f, 0.3f}, {0.7f, 0.1f, 0.9f}, {0.2f, 0.4f, std::nextafter(0.6f, 1.0f)})));
}

TEST_CASE("whole numbers: singular exactly where the determinant is 0") {
    RandomSequence random(1, 0);
    int singular = 0;
    for (int i = 0; i < 20000; ++i) {
        std::array<std::array<int, 3>, 3> m{};
        for (auto& column : m)
            for (auto& entry : column) entry = random.whole(-2, 2);
        const int determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
                                m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
                                m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
        const auto column = [&](std::size_t j) {
            return Vec3f{static_cast<float>(m[j][0]), static_cast<float>(m[j][1]), static_cast<float>(m[j][2])};
        };
        if (is_singular(linear(column(0), column(1), column(2))) != (determinant == 0)) FAIL_CHECK("case " << i);
        singular += determinant == 0 ? 1 : 0;
    }
    CHECK(singular > 1000);
}
