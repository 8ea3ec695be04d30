#include "catch.h"
#include "radiosity/polygons.h"

#include "raylab/radiosity/form_factor/contour_form_factor.h"
#include "raylab/radiosity/form_factor/hemicube.h"
#include "raylab/radiosity/form_factor/polygon_form_factor.h"

#include <numeric>

using namespace raylab;

namespace {

const Vec3d up{0, 0, 1}, north{0, 1, 0}, origin{0, 0, 0};

std::vector<double> row(const Vec3d& point, const Vec3d& normal, const Vec3d& top,
                        const std::vector<Vertices>& polygons, int resolution,
                        DeltaFactors factors = DeltaFactors::normalised) {
    const std::vector<std::span<const Vec3d>> views(polygons.begin(), polygons.end());
    return form_factor_row(hemicube(point, normal, top, views, resolution), polygons.size(), factors);
}

double delta_sum(int resolution) {
    double sum = 0;
    for (const HemicubeFace& face : hemicube(origin, up, north, {}, resolution).faces)
        sum += std::accumulate(face.delta_factors.begin(), face.delta_factors.end(), 0.0);
    return sum;
}

// The relative error, as the root of its mean square, of squares in the face along the normal, anywhere on it.
double error(double side, int resolution) {
    double squares = 0;
    constexpr int count = 100;
    for (std::uint64_t i = 0; i < count; ++i) {
        RandomSequence random(51, i);
        const double x = random.between(-1, 1 - side), y = random.between(-1, 1 - side);
        const Vertices square = rectangle({x, y, 1}, {0, side, 0}, {side, 0, 0});
        squares +=
            std::pow(row(origin, up, north, {square}, resolution)[0] / contour_form_factor(origin, up, square) - 1, 2);
    }
    return std::sqrt(squares / count);
}

}  // namespace

TEST_CASE("delta factors sum to 1 but for an error that falls with the square of the resolution") {
    CHECK_THAT(delta_sum(32) - 1, WithinRel(5.3e-4, 0.02));
    CHECK_THAT(delta_sum(128) - 1, WithinRel(3.3e-5, 0.02));
    CHECK_THAT(delta_sum(512) - 1, WithinRel(2.1e-6, 0.03));
    CHECK_THAT((delta_sum(32) - 1) / (delta_sum(512) - 1), WithinRel(256.0, 0.01));
}

TEST_CASE("in a closed room all is seen: a row sums to 1") {
    RandomSequence random(52, 0);
    for (int i = 0; i < 20; ++i) {
        const Vec3d point{random.between(0.1, 1.9), random.between(0.1, 0.9), 0}, top = random.unit_vector_across(up);
        const auto shares = row(point, up, top, room({2, 1, 3}, 3), 32);
        CHECK_THAT(std::accumulate(shares.begin(), shares.end(), 0.0), WithinAbs(1, 1e-14));
        for (std::size_t k = 0; k < 9; ++k) CHECK(shares[k] == 0);  // the floor does not see itself
    }
}

TEST_CASE("a fine hemicube sees what the contour integral sees, in every direction") {
    const auto walls = room({2, 1, 3}, 2);
    for (std::uint64_t i = 0; i < 10; ++i) {
        RandomSequence random(53, i);
        const Vec3d point{random.between(0.3, 1.7), random.between(0.3, 0.7), random.between(0.3, 2.7)};
        const Vec3d normal = random.unit_vector(), top = random.unit_vector_across(normal);
        const auto shares = row(point, normal, top, walls, 256);
        for (std::size_t k = 0; k < walls.size(); ++k)
            CHECK_THAT(shares[k], WithinAbs(contour_form_factor(point, normal, walls[k]), 2e-3));
    }
}

TEST_CASE("the error of a square falls with the resolution, faster for none: slope -1") {
    const double coarse = error(0.5, 32), fine = error(0.5, 512);
    CHECK_THAT(coarse, WithinRel(2.5e-2, 0.3));
    CHECK_THAT(fine, WithinRel(1.6e-3, 0.3));
    CHECK_THAT(std::log(coarse / fine) / std::log(16), WithinAbs(1, 0.1));
    CHECK(error(0.02, 32) > 1);  // a square smaller than a pixel is seen whole or not at all
}

TEST_CASE("a nearer polygon hides a farther one, whichever comes first") {
    const Vertices near = rectangle({-0.5, -0.5, 1}, north, {1, 0, 0}),
                   far = rectangle({-1, -1, 2}, 2.0 * north, {2, 0, 0});
    const auto one = row(origin, up, north, {near, far}, 64), other = row(origin, up, north, {far, near}, 64);
    CHECK(one[0] > 0.2);
    CHECK(one[1] == 0);
    CHECK(other[1] == one[0]);
    CHECK(other[0] == 0);
}

TEST_CASE("polygons that pass through one another: each pixel sees the nearer") {
    // Two planes that cross above the point: left of the middle the first is lower, right of it the second.
    const Vertices first{{-1, -1, 1}, {-1, 1, 1}, {1, 1, 3}, {1, -1, 3}},
        second{{-1, -1, 3}, {-1, 1, 3}, {1, 1, 1}, {1, -1, 1}};
    const std::vector<std::span<const Vec3d>> views{first, second};
    const HemicubeFace face = hemicube(origin, up, north, views, 32).faces[0];
    for (int column = 0; column < 32; ++column) {
        const auto middle = static_cast<std::size_t>(16 * 32 + column);
        CHECK(face.nearest[middle] == (column < 16 ? 0 : 1));
    }
}

TEST_CASE("of equally near polygons the first is seen") {
    const Vertices square = rectangle({-0.5, -0.5, 1}, north, {1, 0, 0});
    const auto shares = row(origin, up, north, {square, square}, 64);
    CHECK(shares[0] > 0);
    CHECK(shares[1] == 0);
}

TEST_CASE("neighbours share their border: no pixel sees through, none is counted twice") {
    std::vector<Vertices> tiles;
    for (int i = -4; i < 4; ++i)
        for (int j = -4; j < 4; ++j) tiles.push_back(rectangle({0.25 * i, 0.25 * j, 1}, 0.25 * north, {0.25, 0, 0}));
    const Vertices whole = rectangle({-1, -1, 1}, 2.0 * north, {2, 0, 0});
    for (const int resolution : {8, 64, 100}) {  // at 8, 64 borders pass between pixels; at 100 through their middles
        const auto shares = row(origin, up, north, tiles, resolution);
        CHECK_THAT(std::accumulate(shares.begin(), shares.end(), 0.0),
                   WithinRel(row(origin, up, north, {whole}, resolution)[0], 1e-13));
    }
}

TEST_CASE("the patch's own side, its twin and backs of others are not seen") {
    for (std::uint64_t i = 0; i < 100; ++i) {
        RandomSequence random(54, i);
        const Placement place(random, std::pow(10, random.between(-2, 2)), 10);
        const Vertices side = place(parallel_pair(1, 1, 1).from), back = turned(place(parallel_pair(1, 1, 1).to));
        const Vec3d top = glm::normalize(side[1] - side[0]);
        for (const double share :
             row(polygon_ball(side).center, polygon_normal(side), top, {side, turned(side), back}, 16))
            CHECK(share == 0);
    }
}

TEST_CASE("from a patch's centre near squares are misjudged by a third, distant ones by nothing") {
    const auto [distance, percent] = GENERATE(std::pair{0.1, 17.1}, std::pair{0.5, 33.4}, std::pair{1.0, 19.8},
                                              std::pair{2.0, 7.1}, std::pair{5.0, 1.30}, std::pair{10.0, 0.33});
    const auto [from, to] = parallel_pair(1, 1, distance);
    const double truth = polygon_form_factor(from, to);
    CHECK_THAT(100 * (contour_form_factor({0.5, 0.5, 0}, up, to) / truth - 1), WithinRel(percent, 0.02));
    if (distance == 0.5)
        CHECK_THAT(100 * (row({0.5, 0.5, 0}, up, north, {to}, 1024)[0] / truth - 1), WithinAbs(33.4, 0.3));
}
