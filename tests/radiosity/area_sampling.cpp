#include "catch.h"
#include "radiosity/polygons.h"

#include "raylab/radiosity/form_factor/area_sampling.h"
#include "raylab/radiosity/form_factor/disk_form_factor.h"
#include "raylab/radiosity/form_factor/polygon_form_factor.h"
#include "raylab/radiosity/form_factor/uniform_points.h"

using namespace raylab;

namespace {

constexpr std::array patterns{PairPattern::random, PairPattern::jittered, PairPattern::low_discrepancy};

double everything(const Vec3d&, const Vec3d&) { return 1; }

}  // namespace

TEST_CASE("the mean over pairs of points is within four of its standard errors of the truth") {
    for (std::uint64_t i = 0; i < 40; ++i) {
        RandomSequence random(41, i);
        const auto [from, to] = facing_pair(random, random.between(2, 6));
        const double truth = polygon_form_factor(from, to);
        for (const PairPattern pattern : patterns) {
            const auto sampled =
                sampled_form_factor(from, to, {.pairs = 4096, .pattern = pattern, .seed = i}, everything);
            CHECK(std::abs(sampled.value - truth) <= 4 * sampled.standard_error);
            CHECK(sampled.standard_error < 0.05 * truth);
            CHECK(sampled.standard_error > 0);
        }
    }
}

TEST_CASE("the standard error is the root of the mean squared error") {
    const auto [from, to] = parallel_pair(1, 1, 1);
    for (const PairPattern pattern : patterns) {
        double errors = 0, estimates = 0;
        for (std::uint64_t seed = 0; seed < 400; ++seed) {
            const auto sampled =
                sampled_form_factor(from, to, {.pairs = 256, .pattern = pattern, .seed = seed}, everything);
            errors += std::pow(sampled.value - 0.199824895698387, 2);
            estimates += sampled.standard_error * sampled.standard_error;
        }
        CHECK_THAT(estimates, WithinRel(errors, 0.25));  // the mean of 400 squares is known to 7 %
    }
}

TEST_CASE("of polygons that are partly behind one another, only what is in front counts") {
    const Vertices around = rectangle({-5, 0, 0}, {6, 0, 0}, {0, 1, 0});
    const Vertices sunk = rectangle({0, 0, -3}, {0, 1, 0}, {0, 0, 4});
    for (const PairPattern pattern : patterns) {
        const auto sampled = sampled_form_factor(around, sunk, {.pairs = 100'000, .pattern = pattern}, everything);
        CHECK(std::abs(sampled.value - 0.200043776075403 / 6) <= 4 * sampled.standard_error);
    }
}

TEST_CASE("jittered pairs err less than random ones, and the low-discrepancy sequence least") {
    const auto [from, to] = parallel_pair(1, 1, 1);
    std::array<double, 3> squares{};
    for (std::uint64_t seed = 0; seed < 40; ++seed)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto sampled =
                sampled_form_factor(from, to, {.pairs = 4096, .pattern = patterns[i], .seed = seed}, everything);
            squares[i] += std::pow(sampled.value - 0.199824895698387, 2);
        }
    CHECK(squares[1] < 0.25 * squares[0]);
    CHECK(squares[2] < squares[1]);
}

TEST_CASE("what is hidden does not count, and a share counts as one") {
    const auto [from, to] = parallel_pair(1, 1, 1);
    const auto all = sampled_form_factor(from, to, {}, everything);
    CHECK(sampled_form_factor(from, to, {}, [](const Vec3d&, const Vec3d&) { return 0.0; }).value == 0);
    const auto half = sampled_form_factor(from, to, {}, [](const Vec3d&, const Vec3d&) { return 0.5; });
    CHECK(half.value == 0.5 * all.value);
    const auto by_place = sampled_form_factor(from, to, {}, [](const Vec3d& p, const Vec3d& q) {
        CHECK(p.z == 0);
        CHECK(q.z == 1);
        return 1.0;
    });
    CHECK(by_place.value == all.value);
}

TEST_CASE("as many pairs are asked as are wanted, or a few more") {
    const auto [from, to] = parallel_pair(1, 1, 1);
    for (const int pairs : {1, 16, 100, 256, 1000}) {
        for (const PairPattern pattern : patterns) {
            int asked = 0;
            const auto sampled = sampled_form_factor(from, to, {.pairs = pairs, .pattern = pattern},
                                                     [&](const Vec3d&, const Vec3d&) { return 1.0 + 0 * ++asked; });
            CHECK(asked == sampled.pairs);
            CHECK(asked >= pairs);
            CHECK(asked <= std::max(16, 2 * pairs + 16));
        }
    }
}

TEST_CASE("uniform points of a polygon: each half of it receives its share") {
    RandomSequence random(42, 0);
    for (int i = 0; i < 20; ++i) {
        const Vertices polygon = random_polygon(random, {1, 2, 3}, {0, 0, 1}, 2);
        const UniformPoints points(polygon);
        CHECK_THAT(points.area(), WithinRel(polygon_area(polygon), 1e-14));
        const PatchPlane cut{polygon_ball(polygon).center, random.unit_vector_across({0, 0, 1})};
        const Vertices part = clipped_to_front(polygon, cut, 0);
        constexpr int side = 100;
        int inside = 0;
        for (int k = 0; k < side * side; ++k)
            inside += cut.height(points.at((k % side + 0.5) / side, (k / side + 0.5) / side)) > 0;
        CHECK_THAT(1.0 * inside / (side * side), WithinAbs(polygon_area(part) / polygon_area(polygon), 0.01));
    }
}

TEST_CASE("the disk approximation errs as it is known to, by a third at half a side's distance") {
    struct Known {
        double distance, percent, last_digit;
    };
    const auto [distance, percent, last_digit] =
        GENERATE(Known{0.1, 17.2, 0.1}, Known{0.5, 34.9, 0.1}, Known{1, 20.8, 0.1}, Known{2, 7.5, 0.1},
                 Known{5, 1.36, 0.01}, Known{10, 0.35, 0.01});
    const auto [from, to] = parallel_pair(1, 1, distance);
    CHECK_THAT(100 * (disk_form_factor(from, to) / polygon_form_factor(from, to) - 1),
               WithinAbs(percent, 0.51 * last_digit));
    CHECK(disk_form_factor(from, turned(to)) == 0);
}
