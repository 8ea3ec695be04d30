#include "catch.h"
#include "radiosity/polygons.h"

#include "raylab/radiosity/form_factor/point_sampled_contour.h"
#include "raylab/radiosity/form_factor/polygon_form_factor.h"

#include <thread>

using namespace raylab;

namespace {

double factor(const PolygonPair& pair) { return polygon_form_factor(pair.from, pair.to); }

}  // namespace

TEST_CASE("parallel squares: the catalogue's numbers to twelve digits") {
    CHECK_THAT(factor(parallel_pair(1, 1, 1)), WithinRel(0.199824895698387, 1e-12));
    CHECK_THAT(factor(parallel_pair(2, 2, 1)), WithinRel(0.415253283577147, 1e-12));
    CHECK_THAT(factor(parallel_pair(1, 2, 1)), WithinRel(0.285875384850715, 1e-12));
    CHECK_THAT(factor(parallel_pair(0.5, 0.5, 1)), WithinRel(0.0685895888185524, 1e-12));
    CHECK_THAT(factor(parallel_pair(0.2, 0.2, 1)), WithinRel(0.0124039773132451, 1e-12));
    CHECK_THAT(factor(parallel_pair(0.1, 0.1, 1)), WithinRel(0.00316205683875760, 1e-12));
    CHECK_THAT(factor(parallel_pair(10, 10, 1)), WithinRel(0.826994522397257, 1e-12));
    CHECK_THAT(factor(parallel_pair(1000, 1000, 1)), WithinRel(0.99800563190757973, 1e-12));
}

TEST_CASE("shifted parallel rectangles: the catalogue's numbers to twelve digits") {
    CHECK_THAT(factor(parallel_pair(1, 1, 1, 1)), WithinRel(0.0860504891523273, 1e-12));
    CHECK_THAT(factor(parallel_pair(1, 1, 1, 1, 1)), WithinRel(0.0433274095741047, 1e-12));
    const Vertices larger = rectangle({0.5, -1, 0.75}, {0, 2, 0}, {2, 0, 0});
    CHECK_THAT(polygon_form_factor(parallel_pair(1, 1, 1).from, larger), WithinRel(0.334459184072937, 1e-12));
}

TEST_CASE("squares that share an edge, at any angle, to twelve digits") {
    const auto [degrees, expected] = GENERATE(std::pair{30, 0.61902832309080325}, std::pair{60, 0.37090532115005144},
                                              std::pair{90, 0.20004377607540315}, std::pair{120, 0.086615001118276059},
                                              std::pair{150, 0.02134532541268937});
    CHECK_THAT(factor(hinged_pair(1, 1, degrees * std::numbers::pi / 180)), WithinRel(expected, 1e-12));
}

TEST_CASE("perpendicular rectangles that share an edge: the catalogue's numbers to twelve digits") {
    CHECK_THAT(factor(hinged_pair(2, 1)), WithinRel(0.23285260279536189, 1e-12));
    CHECK_THAT(factor(hinged_pair(1, 2)), WithinRel(0.11642630139768094, 1e-12));
    CHECK_THAT(factor(hinged_pair(0.5, 1)), WithinRel(0.14618667910571332, 1e-12));
    CHECK_THAT(factor(hinged_pair(0.1, 0.1)), WithinRel(0.28188780678790143, 1e-12));
    CHECK_THAT(factor(hinged_pair(5, 0.2)), WithinRel(0.40028631083095655, 1e-12));
}

TEST_CASE("what a patch in a closed room sends out arrives, also where walls are divided differently") {
    for (const auto& cells : {std::pair{1, 1}, std::pair{2, 3}, std::pair{3, 2}, std::pair{1, 5}}) {
        const Vec3d size{1, 2, 0.7};
        const Vertices sender = room(size, cells.first)[0];
        double sum = 0;
        for (const Vertices& wall : room(size, cells.second)) sum += polygon_form_factor(sender, wall);
        INFO(cells.first << " and " << cells.second);
        CHECK_THAT(sum, WithinAbs(1, 1e-12));
    }
}

TEST_CASE("what a face of a tetrahedron sends out arrives at the other three") {
    for (std::uint64_t i = 0; i < 30; ++i) {
        RandomSequence random(21, i);
        const Vec3d a = random.in_cube(), b = random.in_cube(), c = random.in_cube();
        Vec3d d = random.in_cube();
        if (dot(cross(b - a, c - a), d - a) < 0) d = a + b - d;
        if (dot(cross(b - a, c - a), d - a) < 0.05) continue;
        const Vertices from{a, b, c};
        const double sum = polygon_form_factor(from, Vertices{a, d, b}) + polygon_form_factor(from, Vertices{b, d, c}) +
                           polygon_form_factor(from, Vertices{c, d, a});
        CHECK_THAT(sum, WithinAbs(1, 1e-12));
    }
}

TEST_CASE("random polygons at any distance: as the contour integral at many points says") {
    for (std::uint64_t i = 0; i < 60; ++i) {
        RandomSequence random(22, i);
        const auto pair = facing_pair(random, random.between(3, 40));
        CHECK_THAT(factor(pair), WithinRel(point_sampled_contour(pair.from, pair.to, 16), 1e-11));
    }
}

TEST_CASE("reciprocity: area times form factor is the same from both sides") {
    for (std::uint64_t i = 0; i < 60; ++i) {
        RandomSequence random(23, i);
        auto [from, to] = facing_pair(random, random.between(1.5, 6));
        for (Vec3d& vertex : to) vertex *= random.whole(0, 1) == 0 ? 1.0 : 0.5;
        CHECK_THAT(exchange_area(from, to), WithinRel(exchange_area(to, from), 1e-11));
    }
}

TEST_CASE("a polygon cut in two receives the sum of its parts") {
    for (std::uint64_t i = 0; i < 60; ++i) {
        RandomSequence random(24, i);
        const auto [from, to] = facing_pair(random, random.between(1.2, 5));
        const PatchPlane cut{polygon_ball(to).center, random.unit_vector()};
        double sum = 0;
        for (const PatchPlane& side : {cut, cut.turned()})
            sum += polygon_form_factor(from, clipped_to_front(to, side, 0));
        CHECK_THAT(polygon_form_factor(from, to), WithinRel(sum, 1e-11));
    }
}

TEST_CASE("only what is in front of the other's plane counts") {
    const Vertices floor = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const Vertices sunk = rectangle({0, 0, -3}, {0, 1, 0}, {0, 0, 4});  // rises through the floor's plane to height 1
    CHECK_THAT(polygon_form_factor(floor, sunk), WithinRel(0.200043776075403, 1e-12));
    const Vertices around = rectangle({-5, 0, 0}, {6, 0, 0}, {0, 1, 0});  // five sixths lie behind the wall
    CHECK_THAT(exchange_area(around, sunk), WithinRel(0.200043776075403, 1e-12));
    CHECK(exchange_area(floor, turned(sunk)) == 0);
}

TEST_CASE("polygons in one plane, and the two sides of one, exchange nothing") {
    for (std::uint64_t i = 0; i < 50; ++i) {
        RandomSequence random(25, i);
        const Placement place(random, std::pow(10, random.between(-3, 3)), 10);
        const Vertices one = place(parallel_pair(1, 1, 1).from);
        const Vertices beside = place(rectangle({1, 0.3, 0}, {1, 0, 0}, {0, 1, 0}));
        CHECK(exchange_area(one, beside) == 0);
        CHECK(exchange_area(one, turned(beside)) == 0);
        CHECK(exchange_area(one, turned(one)) == 0);
        CHECK(exchange_area(one, one) == 0);
    }
}

TEST_CASE("a wall that stands in the middle of a floor: the sum over the parts of the floor") {
    const Vertices wall = rectangle({0.3, 0.2, 0}, {0, 0.5, 0}, {0, 0, 1});  // touches nothing of the floor's contour
    double sum = 0;
    for (const double y : {0.0, 0.2, 0.7})
        sum += exchange_area(rectangle({0.3, y, 0}, {0.7, 0, 0},
                                       {0,
                                        (y == 0.0   ? 0.2
                                         : y == 0.2 ? 0.5
                                                    : 0.3),
                                        0}),
                             wall);
    CHECK_THAT(exchange_area(rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), wall), WithinRel(sum, 1e-12));
}

TEST_CASE("a wall that stands askew across the floor's border: the sum over the parts of the wall") {
    const Vertices floor = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const Vec3d start{0.2, -0.7, 0}, foot{0.4, 2, 0}, rise{0, 0, 1};
    double sum = 0;
    for (const auto& [from, to] : {std::pair{0.0, 0.35}, {0.35, 0.6}, {0.6, 0.85}, {0.85, 1.0}})
        sum += exchange_area(floor, rectangle(start + from * foot, (to - from) * foot, rise));
    CHECK_THAT(exchange_area(floor, rectangle(start, foot, rise)), WithinRel(sum, 1e-12));
}

TEST_CASE("a plate turned askew close above another, whose edges nearly cross: the sum over the plate's parts") {
    const Vertices floor = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const Vec3d corner{0.5, -0.3, 1e-3}, u{-0.5, 0.7, 0}, v{0.7, 0.5, 0};
    double sum = 0;
    for (const double i : {0.0, 0.5})
        for (const double j : {0.0, 0.5})
            sum += exchange_area(floor, rectangle(corner + i * u + j * v, 0.5 * u, 0.5 * v));
    CHECK_THAT(exchange_area(floor, rectangle(corner, u, v)), WithinRel(sum, 1e-12));
}

TEST_CASE("a small polygon that touches a large one keeps its digits") {
    // A square of this width on the floor, with one edge at the foot of a wall of 1 x 1, a quarter from its end; the
    // sum for perpendicular rectangles, computed with 60 digits.
    const auto [w, expected] = GENERATE(std::pair{0x1p-7, 0.49616531482501874}, std::pair{0x1p-14, 0.49996978257134808},
                                        std::pair{0x1p-20, 0.49999952782094278});
    const Vertices square = rectangle({0, 0.25, 0}, {w, 0, 0}, {0, w, 0});
    CHECK_THAT(polygon_form_factor(square, hinged_pair(1, 1).to), WithinRel(expected, 1e-12));
}

TEST_CASE("a strip along an edge loses digits in proportion to its narrowness") {
    // C-14 with h = 1, computed with 60 digits.
    const auto [w, expected] = GENERATE(std::pair{1e-2, 0.4895849268506683}, std::pair{1e-4, 0.49982255552878213},
                                        std::pair{1e-6, 0.49999749261968876});
    CHECK_THAT(factor(hinged_pair(1, w)), WithinRel(expected, 1e-15 / w));
}

TEST_CASE("a small distant pair keeps its digits") {
    CHECK_THAT(factor(parallel_pair(1e-2, 1e-2, 1)), WithinRel(3.1828866732829196e-5, 1e-13));
    CHECK_THAT(factor(parallel_pair(1e-6, 1e-6, 1)), WithinRel(3.1830988618357846e-13, 1e-13));
}

TEST_CASE("neither the unit of length nor the place matters") {
    for (const double unit : {1e-6, 1.0, 1e6})
        for (std::uint64_t i = 0; i < 10; ++i) {
            RandomSequence random(26, i);
            const Placement place(random, unit, 10 * unit);
            const auto [parallel_from, parallel_to] = parallel_pair(1, 1, 1);
            CHECK_THAT(polygon_form_factor(place(parallel_from), place(parallel_to)),
                       WithinRel(0.199824895698387, 1e-12));
            const auto [floor, wall] = hinged_pair(1, 1);
            CHECK_THAT(polygon_form_factor(place(floor), place(wall)), WithinRel(0.200043776075403, 1e-12));
        }
}

TEST_CASE("several threads at once get the same bits", "[threads]") {
    const auto pair = hinged_pair(0.7, 1.1, 1);
    std::vector<double> answers(8);
    {
        std::vector<std::jthread> threads;
        for (double& answer : answers)
            threads.emplace_back(
                [&answer, &pair] { answer = factor(pair) + point_sampled_contour(pair.from, pair.to, 5); });
    }
    for (const double answer : answers) CHECK(answer == answers[0]);
    CHECK(answers[0] == factor(pair) + point_sampled_contour(pair.from, pair.to, 5));
}
