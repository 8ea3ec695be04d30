#include "catch.h"
#include "radiosity/polygons.h"

#include "raylab/radiosity/form_factor/dilogarithm.h"
#include "raylab/radiosity/form_factor/edge_pair.h"

#include <numbers>

using namespace raylab;

namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

PolygonEdge edge(const Vec3d& start, const Vec3d& end) {
    return {start, glm::normalize(end - start), glm::distance(start, end)};
}

void check_equal(const Complex& found, const Complex& expected) {
    CAPTURE(found, expected);
    CHECK(std::abs(found - expected) <= 4e-16 * std::max(1.0, std::abs(expected)));
}

}  // namespace

TEST_CASE("the dilogarithm's known values") {
    const double golden = std::log((1 + std::sqrt(5.0)) / 2), log_two = std::log(2.0);
    check_equal(dilogarithm(0), 0);
    check_equal(dilogarithm(1), pi * pi / 6);
    check_equal(dilogarithm(-1), -pi * pi / 12);
    check_equal(dilogarithm(0.5), pi * pi / 12 - log_two * log_two / 2);
    check_equal(dilogarithm(std::exp(-2 * golden)), pi * pi / 15 - golden * golden);
    check_equal(dilogarithm(-std::exp(golden)), -pi * pi / 10 - golden * golden);
    check_equal(dilogarithm({0, 1}), {-pi * pi / 48, 0.91596559417721901505});                 // Catalan
    check_equal(dilogarithm(std::polar(1.0, pi / 3)), {pi * pi / 36, 1.0149416064096536250});  // Gieseking
    check_equal(dilogarithm({1, 1}), {pi * pi / 16, 0.91596559417721901505 + pi / 4 * log_two});
}

TEST_CASE("dilogarithms of z, -z and z^2, and of z and 1 - z, are related as Euler found") {
    for (std::uint64_t i = 0; i < 200; ++i) {
        RandomSequence random(31, i);
        const Complex z = std::polar(std::pow(10, random.between(-3, 3)), random.between(0.01, pi - 0.01));
        const double size = 1 + std::norm(std::log(z));
        CAPTURE(z);
        CHECK(std::abs(dilogarithm(z) + dilogarithm(-z) - dilogarithm(z * z) / 2.0) < 4e-15 * size);
        CHECK(std::abs(dilogarithm(z) + dilogarithm(1.0 - z) + std::log(z) * std::log(1.0 - z) - pi * pi / 6) <
              4e-15 * size);
    }
}

TEST_CASE("two edges: the closed form is what the numerical integral says") {
    for (std::uint64_t i = 0; i < 300; ++i) {
        RandomSequence random(32, i);
        const auto point = [&] { return random.in_cube(); };
        const PolygonEdge a = edge(point(), point()), b = edge(point(), point());
        const double reach = edge_pair_reach(a, b);
        CHECK_THAT(edge_pair_closed(a, b), WithinAbs(edge_pair_numerical(a, b), 1e-15 * (4 + reach * reach)));
    }
}

TEST_CASE("edges that are parallel, meet, cross, share an end or lie on each other: as the numerical integral says") {
    const PolygonEdge a = edge({0, 0, 0}, {1, 0, 0});
    const auto b =
        GENERATE(edge({0, 0, 0}, {1, 0, 0}), edge({0.7, 0, 0}, {-0.4, 0, 0}), edge({0.2, 0.5, 1}, {1.2, 0.5, 1}),
                 edge({3, 0, 0}, {2, 0, 0}), edge({0, 0, 0}, {0.3, 1, 0}), edge({1, 0, 0}, {2, 1, 1}),
                 edge({0.4, -1, 0}, {0.6, 1, 0}), edge({0.4, -1, 1e-9}, {0.6, 1, 1e-9}),
                 edge({0.4, -1, 1e-3}, {0.6, 1, 1e-3}), edge({0.5, 0, 1}, {0.8, 0, 2}));
    CHECK_THAT(edge_pair_closed(a, b), WithinAbs(edge_pair_numerical(a, b), 2e-14));
    CHECK_THAT(edge_pair_closed(b, a), WithinAbs(edge_pair_numerical(a, b), 2e-14));
}
