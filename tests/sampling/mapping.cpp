#include "catch.h"
#include "sampling/cell_counts.h"
#include "sampling/direction_cells.h"

#include "raylab/sampling/mapping/cosine_direction.h"
#include "raylab/sampling/mapping/ggx.h"
#include "raylab/sampling/mapping/lens_point.h"
#include "raylab/sampling/mapping/power_cosine.h"
#include "raylab/sampling/mapping/sphere_cone.h"
#include "raylab/sampling/sequence.h"

using namespace raylab;

namespace {

constexpr std::uint64_t samples = 40'000;
// Each of the chi-square tests below is wrong about a good map once in a million; there are thirty.
constexpr double alpha = 1e-6;

// The turn around z as a share of the whole.
double turn_share(double x, double y) {
    const double turn = std::atan2(y, x) / (2 * std::numbers::pi);
    return std::min(turn < 0 ? turn + 1 : turn, 1 - 0x1p-53);
}

// 1 - z of a unit vector, with all its digits.
double below_top(const Vec3d& direction) {
    return (direction.x * direction.x + direction.y * direction.y) / (1 + direction.z);
}

// The p-value of what should be uniform in the unit square, made of two uniform numbers.
template <class Share>
double p_value_of(const Share& share) {
    CellCounts cells(12);
    for (std::uint64_t i = 0; i < samples; ++i) {
        RandomSequence random(17, i);
        const double u = random.next();
        const auto [x, y] = share(u, random.next());
        cells.add(std::min(x, 1 - 0x1p-53), y);
    }
    return cells.p_value();
}

}  // namespace

TEST_CASE("points of the lens are uniform by area: squared radius and turn are uniform numbers") {
    const auto share = [](double u, double v) -> std::array<double, 2> {
        const auto [x, y] = lens_point(0.3, u, v);
        return {(x * x + y * y) / 0.09, turn_share(x, y)};
    };
    CHECK(p_value_of(share) > alpha);
    const auto [x, y] = lens_point(2, 0, 0);
    CHECK_THAT(std::hypot(x, y), WithinRel(2, 1e-15));
    CHECK(concentric_disk(0.5, 0.5).x == 0);
}

TEST_CASE("the concentric map keeps neighbours: a small step in the square is a small step on the disk") {
    for (double u = 0; u < 1; u += 0.01)
        for (double v = 0; v < 1; v += 0.01) {
            const auto a = concentric_disk(u, v), b = concentric_disk(u + 1e-6, v), c = concentric_disk(u, v + 1e-6);
            CHECK(std::hypot(a.x - b.x, a.y - b.y) < 4e-6);
            CHECK(std::hypot(a.x - c.x, a.y - c.y) < 4e-6);
        }
}

TEST_CASE("the cosine lobe: the squared sine and the turn are uniform, and the density is cos / pi") {
    const auto share = [](double u, double v) -> std::array<double, 2> {
        const auto [d, pdf] = cosine_direction(u, v);
        CHECK_THAT(glm::length(d), WithinRel(1, 1e-15));
        CHECK_THAT(pdf, WithinRel(d.z / std::numbers::pi, 1e-15));
        return {d.x * d.x + d.y * d.y, turn_share(d.x, d.y)};
    };
    CHECK(p_value_of(share) > alpha);
}

TEST_CASE(
    "a cosine to any power, from the hemisphere to a lobe as narrow as 1e-5: cos^(n + 1) and the turn are uniform") {
    for (const double n : {0.0, 1.0, 20.0, 1000.0, 1e10}) {
        INFO(n);
        CHECK(p_value_of([n](double u, double v) -> std::array<double, 2> {
                  const Vec3d d = power_cosine_direction(n, u, v);
                  return {-std::expm1((n + 1) * std::log1p(-below_top(d))), turn_share(d.x, d.y)};
              }) > alpha);
        const auto all = DirectionCells(0).integrals([&](const Vec3d& d) { return power_cosine_pdf(n, d.z); });
        if (n < 100) CHECK_THAT(all.back(), WithinAbs(0, 1e-4));  // the densities integrate to 1
    }
    CHECK(power_cosine_pdf(5, -0.5) == 0);
}

TEST_CASE("a cone of any width, from a millionth of a millionth to a half space: height and turn are uniform") {
    for (const double sine : {1e-12, 1e-6, 0.01, 0.5, 1.0}) {
        const SphereCone cone = SphereCone::around(sine, 1);
        const double height = cone.solid_angle() / (2 * std::numbers::pi);
        INFO(sine);
        CHECK(p_value_of([&](double u, double v) -> std::array<double, 2> {
                  const Vec3d d = cone.direction(u, v);
                  return {below_top(d) / height, turn_share(d.x, d.y)};
              }) > alpha);
    }
}

TEST_CASE("the solid angle of a sphere has fifteen digits, where 1 - cos as it stands has none") {
    for (const double sine : {1e-9, 1e-7, 1e-5})
        CHECK_THAT(SphereCone::around(sine, 1).solid_angle(),
                   WithinRel(std::numbers::pi * sine * sine * (1 + sine * sine / 4), 4e-16));
    CHECK(1 - std::sqrt(1 - 1e-9 * 1e-9) == 0);
    CHECK_THAT(SphereCone::around(3, 5).solid_angle(), WithinRel(2 * std::numbers::pi * 0.2, 1e-15));
    CHECK_THAT(SphereCone::around(1, 1).pdf(), WithinRel(1 / (2 * std::numbers::pi), 1e-15));
}

TEST_CASE("GGX: the facets' area over the surface is that of the surface, and normals are chosen as they show") {
    const double degree = std::numbers::pi / 180;
    for (const double alpha_of_facets : {1.0, 0.4, 0.1}) {
        const DirectionCells whole(0);
        const auto projected = whole.integrals([&](const Vec3d& n) { return ggx_facets(n, alpha_of_facets) * n.z; });
        CHECK_THAT(projected.back(), WithinAbs(0, 2e-3));
        for (const double angle : {0.0, 45.0, 80.0, 89.0}) {
            const Vec3d seen_from{std::sin(angle * degree), 0, std::cos(angle * degree)};
            DirectionCells cells(0, 24, 12);
            for (std::uint64_t i = 0; i < samples; ++i) {
                RandomSequence random(23, i);
                const double u = random.next();
                const Vec3d normal = ggx_visible_normal(seen_from, alpha_of_facets, u, random.next());
                CHECK(dot(normal, seen_from) > -1e-12);
                cells.add(normal);
            }
            const auto expected =
                cells.integrals([&](const Vec3d& n) { return ggx_visible_normal_pdf(seen_from, alpha_of_facets, n); });
            INFO("alpha " << alpha_of_facets << ", " << angle << " degrees, missing " << expected.back());
            CHECK(expected.back() < 2e-3);
            CHECK(cells.p_value(expected) > alpha);
        }
    }
}
