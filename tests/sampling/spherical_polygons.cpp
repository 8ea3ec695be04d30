#include "catch.h"

#include "raylab/sampling/chi_square.h"
#include "raylab/sampling/mapping/solid_angle.h"
#include "raylab/sampling/mapping/spherical_rectangle.h"
#include "raylab/sampling/mapping/spherical_triangle.h"
#include "raylab/sampling/sequence.h"

#include <algorithm>
#include <numbers>

using namespace raylab;

namespace {

constexpr std::size_t per_side = 6;
constexpr std::uint64_t samples = 50'000;
constexpr double alpha = 1e-7;  // of some fifty tests

double rectangle_angle(const Vec3d& corner, const Vec3d& first, const Vec3d& second) {
    const Vec3d opposite = corner + first + second;
    return triangle_solid_angle(corner, corner + first, opposite) +
           triangle_solid_angle(corner, opposite, corner + second);
}

// The samples of a triangle in its parts: lines from a through equal parts of the opposite side, and lines parallel to
// that. `bend` is an error that a sampler might have.
double triangle_p_value(const Vec3d& a, const Vec3d& b, const Vec3d& c, double bend = 0) {
    const SphericalTriangle triangle(a, b, c);
    std::vector<std::uint64_t> counts(per_side * per_side);
    std::vector<double> expected(per_side * per_side);
    const auto corner = [&](std::size_t i, std::size_t k) {
        const double away = static_cast<double>(i) / per_side, along = static_cast<double>(k) / per_side;
        return a + away * ((1 - along) * (b - a) + along * (c - a));
    };
    for (std::size_t i = 0; i < per_side; ++i)
        for (std::size_t k = 0; k < per_side; ++k) {
            const Vec3d near = corner(i, k), far = corner(i + 1, k + 1);
            double angle = triangle_solid_angle(near, corner(i + 1, k), far);
            if (i > 0) angle += triangle_solid_angle(near, far, corner(i, k + 1));
            expected[i * per_side + k] = samples * angle / triangle.solid_angle();
        }
    const Vec3d normal = cross(b - a, c - a);
    for (std::uint64_t i = 0; i < samples; ++i) {
        RandomSequence random(31, i);
        const double u = random.next();
        const Vec3d direction = triangle.direction(u + bend * u * (1 - u), random.next());
        const Vec3d point = direction * (dot(a, normal) / dot(direction, normal)) - a;
        // Its coordinates along b - a and c - a.
        const double square = dot(normal, normal);
        const double to_b = dot(cross(point, c - a), normal) / square, to_c = dot(cross(b - a, point), normal) / square;
        CHECK((to_b > -1e-9 && to_c > -1e-9 && to_b + to_c < 1 + 1e-9));
        const double away = std::clamp(to_b + to_c, 0.0, 1 - 1e-9), along = std::clamp(to_c / away, 0.0, 1 - 1e-9);
        ++counts[static_cast<std::size_t>(away * per_side) * per_side + static_cast<std::size_t>(along * per_side)];
    }
    return chi_square_p_value(counts, expected);
}

double rectangle_p_value(const Vec3d& corner, const Vec3d& first, const Vec3d& second) {
    const Vec3d from{0.5, -2, 0.25};
    const SphericalRectangle rectangle(from, from + corner, first, second);
    std::vector<std::uint64_t> counts(per_side * per_side);
    std::vector<double> expected(per_side * per_side);
    const Vec3d across = first / double{per_side}, up = second / double{per_side};
    for (std::size_t i = 0; i < per_side; ++i)
        for (std::size_t k = 0; k < per_side; ++k)
            expected[i * per_side + k] = samples *
                                         rectangle_angle(corner + double(k) * across + double(i) * up, across, up) /
                                         rectangle.solid_angle();
    for (std::uint64_t i = 0; i < samples; ++i) {
        RandomSequence random(37, i);
        const double u = random.next();
        const Vec3d point = rectangle.point(u, random.next()) - from - corner;
        const double x = dot(point, first) / dot(first, first), y = dot(point, second) / dot(second, second);
        CHECK((x > -1e-9 && x < 1 + 1e-9 && y > -1e-9 && y < 1 + 1e-9));
        const auto cell = [](double t) { return static_cast<std::size_t>(std::clamp(t, 0.0, 1 - 1e-9) * per_side); };
        ++counts[cell(y) * per_side + cell(x)];
    }
    return chi_square_p_value(counts, expected);
}

}  // namespace

TEST_CASE("the solid angle of a triangle: an octant, a tiny one by area over squared distance, one across the sky") {
    CHECK_THAT(triangle_solid_angle({1, 0, 0}, {0, 5, 0}, {0, 0, 2}), WithinRel(std::numbers::pi / 2, 1e-15));
    for (const double size : {1e-3, 1e-6, 1e-9})  // the cosine of the distance costs size^2
        CHECK_THAT(triangle_solid_angle({0, 0, 1}, {size, 0, 1}, {0, size, 1}),
                   WithinRel(size * size / 2, size * size + 1e-15));
    CHECK_THAT(triangle_solid_angle({1e6, 0, 1e-9}, {-1e6, 1e6, 1e-9}, {-1e6, -1e6, 1e-9}),
               WithinRel(2 * std::numbers::pi, 1e-12));
    CHECK(triangle_solid_angle({1, 0, 0}, {2, 1, 0}, {3, 0, 0}) == 0);  // edge-on
}

TEST_CASE("points of a spherical triangle are uniform by solid angle: any shape, near and far, large and tiny") {
    for (std::uint64_t i = 0; i < 12; ++i) {
        RandomSequence random(41, i);
        const Vec3d a = random.in_cube(), b = random.in_cube(), c = random.in_cube();
        CHECK(triangle_p_value(a, b, c) > alpha);
    }
    for (const double size : {0.1, 1e-3, 1e-5}) {
        INFO(size);
        CHECK(triangle_p_value({0.3 * size, 0, 1}, {-size, size, 1.2}, {0.1 * size, -size, 1}) > alpha);
        CHECK(triangle_p_value({0, 0, 1}, {size, 0, 1}, {0, 1, 0.1}) > alpha);  // a strip
    }
    CHECK(triangle_p_value({10, 0, 0.1}, {-10, 10, 0.1}, {-10, -10, 0.1}) > alpha);  // nearly a half space
}

TEST_CASE(
    "a sampler whose density is a tenth too large at one corner, and as much too small at the other side, is found") {
    CHECK(triangle_p_value({0.3, 0, 1}, {-1, 1, 1.2}, {0.1, -1, 1}, 0.1) < alpha);
}

TEST_CASE("points of a spherical rectangle are uniform by solid angle: in front, aside, across the sky, down to 1e-6") {
    CHECK(rectangle_p_value({-1, -1, 2}, {2, 0, 0}, {0, 2, 0}) > alpha);
    CHECK(rectangle_p_value({3, 1, -0.5}, {0, 2, 0}, {0, 0, 5}) > alpha);
    CHECK(rectangle_p_value({-50, -40, 1}, {100, 0, 0}, {0, 100, 0}) > alpha);
    CHECK(rectangle_p_value({1, 1, -1e-3}, {1, 0, 0}, {0, 1, 0}) > alpha);  // at the horizon
    for (std::uint64_t i = 0; i < 12; ++i) {
        RandomSequence random(43, i);
        const Vec3d first = random.in_cube(), corner = random.in_cube();
        CHECK(rectangle_p_value(corner, first, random.between(0.1, 2) * random.unit_vector_across(first)) > alpha);
    }
    for (const double size : {0.1, 1e-2, 1e-3}) {
        INFO(size);
        CHECK(rectangle_p_value({0.7, 0.2, 1}, {size, 0, 0}, {0, size, 0}) > alpha);
    }
}
