#include "catch.h"
#include "radiosity/polygons.h"

#include "raylab/radiosity/form_factor/closed_forms.h"
#include "raylab/radiosity/form_factor/contour_form_factor.h"
#include "raylab/radiosity/form_factor/form_factor_density.h"
#include "raylab/radiosity/form_factor/polygon_points.h"

using namespace raylab;

namespace {

const Vec3d up{0, 0, 1};

// a x b at height 1, one corner above the origin, facing down.
Vertices ceiling(double a, double b) { return parallel_pair(a, b, 1).to; }

}  // namespace

TEST_CASE("a rectangle above a point: the catalogue's numbers") {
    CHECK_THAT(contour_form_factor({0, 0, 0}, up, ceiling(1, 1)), WithinRel(0.138531605994893, 1e-13));
    CHECK_THAT(contour_form_factor({0.5, 0.5, 0}, up, ceiling(1, 1)), WithinRel(0.239456470460774, 1e-13));
    for (const double a : {0.01, 0.3, 2.0, 50.0})
        CHECK_THAT(contour_form_factor({0, 0, 0}, up, ceiling(a, 0.7)),
                   WithinRel(element_to_parallel_rectangle(a, 0.7, 1), 1e-12));
}

TEST_CASE("a wall beside a point: the catalogue's number") {
    const Vertices wall = rectangle({-1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    CHECK_THAT(contour_form_factor({0, 0, 0}, up, wall), WithinRel(0.0557341970025535, 1e-13));
    CHECK_THAT(element_to_perpendicular_rectangle(1, 1, 1), WithinRel(0.0557341970025535, 1e-13));
}

TEST_CASE("what is below the horizon does not count") {
    const Vertices half = rectangle({-2, -1, 0}, {0, 3, 0}, {0, 0, 2});
    const Vertices whole = rectangle({-2, -1, -5}, {0, 3, 0}, {0, 0, 7});
    const double expected = contour_form_factor({0, 0, 0}, up, half);
    CHECK(expected > 0.05);
    CHECK_THAT(contour_form_factor({0, 0, 0}, up, whole), WithinRel(expected, 1e-14));
    CHECK(contour_form_factor({0, 0, 0}, -up, half) == 0);

    const Vertices triangle{{-2, -1, -1}, {-2, 1, -1}, {-2, 0, 1}};  // one corner is above; it is also cut out by hand
    const Vertices tip{{-2, -0.5, 0}, {-2, 0.5, 0}, {-2, 0, 1}};
    CHECK_THAT(contour_form_factor({0, 0, 0}, up, triangle), WithinRel(contour_form_factor({0, 0, 0}, up, tip), 1e-14));
}

TEST_CASE("a vertex or an edge on the horizon changes nothing") {
    const Vertices on{{-2, -1, 0}, {-2, 1, 0}, {-2, 0, 1}};
    const Vertices raised{{-2, -1, 1e-9}, {-2, 1, 1e-9}, {-2, 0, 1}};
    CHECK_THAT(contour_form_factor({0, 0, 0}, up, on), WithinRel(contour_form_factor({0, 0, 0}, up, raised), 1e-8));
    const Vertices stands{{-2, 0, 0}, {-2, 1, 1}, {-2, -1, 1}};  // on one vertex
    const Vertices lower{{-2, 0, -1e-9}, {-2, 1, 1}, {-2, -1, 1}};
    CHECK_THAT(contour_form_factor({0, 0, 0}, up, stands), WithinRel(contour_form_factor({0, 0, 0}, up, lower), 1e-8));
}

TEST_CASE("a polygon seen from behind receives nothing") {
    CHECK(contour_form_factor({0.5, 0.5, 0}, up, turned(ceiling(1, 1))) == 0);
    CHECK(contour_form_factor({0.5, 0.5, 2}, -up, ceiling(1, 1)) == 0);
}

TEST_CASE("a point in the polygon's plane sends nothing there, wherever it lies") {
    const Vertices floor = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    RandomSequence random(11, 0);
    for (const Vec3d& point : {Vec3d{0.5, 0.5, 0}, Vec3d{0.5, 0, 0}, Vec3d{0, 0, 0}, Vec3d{2, 0.5, 0}, Vec3d{2, 0, 0}})
        for (const Vec3d& normal : {up, -up, Vec3d{1, 0, 0}, random.unit_vector()})
            CHECK(contour_form_factor(point, normal, floor) == 0);
}

TEST_CASE("a rotated polygon's own twin, which faces the other way, receives nothing") {
    for (std::uint64_t i = 0; i < 200; ++i) {
        RandomSequence random(12, i);
        const Vertices side = Placement(random, std::pow(10, random.between(-3, 3)), 10)(parallel_pair(1, 1, 1).from);
        CHECK(contour_form_factor(polygon_ball(side).center, polygon_normal(side), turned(side)) == 0);
    }
}

TEST_CASE("just in front of a polygon nearly everything arrives there, and half of it at its edge") {
    const Vertices ceiling_here = ceiling(1, 1);
    CHECK_THAT(contour_form_factor({0.5, 0.5, 1 - 1e-9}, up, ceiling_here), WithinAbs(1, 1e-8));
    CHECK_THAT(contour_form_factor({0.5, 0, 1 - 1e-9}, up, ceiling_here), WithinAbs(0.5, 1e-8));
    CHECK_THAT(contour_form_factor({0, 0, 1 - 1e-9}, up, ceiling_here), WithinAbs(0.25, 1e-8));
}

TEST_CASE("a point inside a closed room sends all of its light to the walls") {
    for (std::uint64_t i = 0; i < 50; ++i) {
        RandomSequence random(13, i);
        const Vec3d point{random.between(0.1, 1.9), random.between(0.1, 0.9), random.between(0.1, 2.9)};
        const Vec3d normal = random.unit_vector();
        double sum = 0;
        for (const Vertices& wall : room({2, 1, 3}, 3)) sum += contour_form_factor(point, normal, wall);
        CHECK_THAT(sum, WithinAbs(1, 1e-13));
    }
}

TEST_CASE("a tiny distant polygon keeps its digits") {
    for (const double half : {1e-4, 1e-6, 1e-8}) {
        const Vertices square = rectangle({-half, -half, 1}, {0, 2 * half, 0}, {2 * half, 0, 0});
        CHECK_THAT(contour_form_factor({0, 0, 0}, up, square),
                   WithinRel(4 * half * half / std::numbers::pi, 2 * half * half + 1e-14));
    }
}

TEST_CASE("a polygon seen under a small angle loses digits in proportion, not with the angle's square") {
    for (const double radius : {1e-2, 1e-4, 1e-6})
        for (std::uint64_t i = 0; i < 50; ++i) {
            RandomSequence random(15, i);
            const Vec3d way = random.unit_vector(), normal = glm::normalize(way + 0.5 * random.unit_vector());
            const Vertices polygon = random_polygon(random, way, -normal, radius);
            double sum = 0;
            for (const PolygonPoint& q : gauss_points(polygon, 6))
                sum += q.area * form_factor_density({0, 0, 0}, normal, q.position, -normal);
            CHECK_THAT(contour_form_factor({0, 0, 0}, normal, polygon), WithinRel(sum, 1e-14 / radius));
        }
}

TEST_CASE("the contour integral is the integral over the area") {
    for (std::uint64_t i = 0; i < 100; ++i) {
        RandomSequence random(14, i);
        const auto [from, to] = facing_pair(random, 4);
        const Vec3d point = polygon_ball(from).center, normal = polygon_normal(from);
        double sum = 0;
        for (const PolygonPoint& q : gauss_points(to, 16))
            sum += q.area * form_factor_density(point, normal, q.position, polygon_normal(to));
        CHECK_THAT(contour_form_factor(point, normal, to), WithinRel(sum, 1e-12));
    }
}

TEST_CASE("the unit of length does not matter") {
    for (const double unit : {1e-6, 1e6}) {
        Vertices scaled = ceiling(1, 1);
        for (Vec3d& vertex : scaled) vertex *= unit;
        CHECK_THAT(contour_form_factor({0, 0, 0}, up, scaled), WithinRel(0.138531605994893, 1e-13));
    }
}
