#include "catch.h"
#include "geometry/every_shape.h"
#include "geometry/verdict.h"
#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/bounds/hull.h"
#include "raylab/geometry/filter/prepared_flat.h"
#include "raylab/geometry/intersect/nearest.h"

using namespace raylab;
using namespace raylab::adversarial;

namespace {

const Annulus ring{{1, 1, 0}, {0, 0, 3}, 5, 10};

oracle::Answer drop(double x, double y, const Annulus& annulus) {
    return oracle::intersect({{x, y, 2}, {0, 0, -1}, {0, std::numeric_limits<double>::infinity()}}, Shape(annulus), {},
                             Sides::both);
}

// The hit of a ray straight down, which starts 2 above the plane z = 0.
std::optional<Candidate> hit_below(float x, float y, const Annulus& annulus, const Affine& placement = {}) {
    DecisionCounts decisions;
    return intersect({{x, y, 2}, {0, 0, -1}}, annulus, placement, decisions);
}

// Aimed at a point of a rim, or next to it.
Ray at_rim(Draw& draw, const Annulus& annulus, const Affine& placement) {
    const Vec3d normal = convert<double>(annulus.normal), across = cross(normal, convert<double>(draw.in_cube(1)));
    const double radius = draw.one_in(2) ? annulus.inner_radius : annulus.outer_radius;
    const double nearly = draw.one_in(2) ? 1 : 1 + std::ldexp(draw.number(-1, 1), -draw.integer(1, 50));
    const Vec3d rim = convert<double>(annulus.center) + glm::normalize(across) * (radius * nearly);
    return through(any_point(draw), transform_point(placement, rim));
}

}  // namespace

TEST_CASE("oracle: an annulus owns both of its rims and not its hole") {
    CHECK(drop(7, 2, ring).hit_kind == oracle::HitKind::interior);
    CHECK(drop(4, 5, ring).hit_kind == oracle::HitKind::boundary);   // 3, 4 from the center
    CHECK(drop(-5, 9, ring).hit_kind == oracle::HitKind::boundary);  // 6, 8
    CHECK(drop(4, std::nextafter(5.0, 4.0), ring).hit_kind == oracle::HitKind::miss);
    CHECK(drop(-5, std::nextafter(9.0, 10.0), ring).hit_kind == oracle::HitKind::miss);
    CHECK(drop(1, 1, ring).hit_kind == oracle::HitKind::miss);
    CHECK(is_eq(drop(4, 5, ring).t.value().compare(2.0)));
    const RayOf<double> inside_plane{{-20, 1, 0}, {1, 0, 0}, {0, 100}};
    CHECK(oracle::intersect(inside_plane, Shape(ring), {}, Sides::both).hit_kind == oracle::HitKind::within);
}

TEST_CASE("a ray hits an annulus on both rims and between them, and misses its hole, one float beside a rim too") {
    CHECK(hit_below(7, 2, ring));
    CHECK(hit_below(4, 5, ring));
    CHECK(hit_below(-5, 9, ring));
    CHECK(hit_below(4, 5, ring)->t == 2);
    CHECK_FALSE(hit_below(1, 1, ring));
    CHECK_FALSE(hit_below(4, std::nextafter(5.0f, 4.0f), ring));
    CHECK_FALSE(hit_below(-5, std::nextafter(9.0f, 10.0f), ring));
    CHECK_FALSE(hit_below(-20, 1, ring));
}

TEST_CASE("a ray that passes a rim of an annulus by less than doubles can tell is decided exactly") {
    const auto hits = [](const Vec3f& origin, float aside) {
        DecisionCounts decisions;
        return intersect({origin, {aside, 0, -1}}, Shape(ring), {}, decisions).has_value();
    };
    const Vec3f inner{4, 5, 2}, outer{7, 9, 2};  // 3, 4 and 6, 8 from the center
    CHECK(hits(inner, 0x1p-60f));
    CHECK_FALSE(hits(inner, -0x1p-60f));
    CHECK(hits(outer, -0x1p-60f));
    CHECK_FALSE(hits(outer, 0x1p-60f));
}

TEST_CASE("the rims of a transformed annulus belong to it, a mirrored and a larger one's too") {
    Affine twice;
    twice.columns = {Vec3f{-2, 0, 0}, Vec3f{0, 2, 0}, Vec3f{0, 0, 2}};
    CHECK(hit_below(-8, 10, ring, twice));
    CHECK(hit_below(10, 18, ring, twice));
    CHECK_FALSE(hit_below(-2, 2, ring, twice));
    CHECK_FALSE(hit_below(-8, std::nextafter(10.0f, 9.0f), ring, twice));
    CHECK_FALSE(hit_below(10, std::nextafter(18.0f, 19.0f), ring, twice));
}

TEST_CASE("an annulus at its rims: every decision is the exact one") {
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        const Annulus annulus = any_annulus(draw);
        const Affine placement = any_placement(draw);
        const Ray ray = at_rim(draw, annulus, placement);
        const Sides sides = any_sides(draw);
        DecisionCounts decisions;
        return fault(ray, oracle::intersect(in<double>(ray), Shape(annulus), placement, sides),
                     intersect(ray, annulus, placement, decisions, sides));
    };
    CHECK(faults(40'000, judge) == "");
}

TEST_CASE("plain doubles decide what a ray does to an annulus, unless it comes close to a rim") {
    int open = 0;
    const PreparedFlat prepared(ring);
    Draw draw(1);
    for (int i = 0; i < 1000; ++i) {
        const Ray ray = through({0, 0, 9}, {draw.number(-15, 15), draw.number(-15, 15), 0});
        open += std::holds_alternative<Undecided>(prepared.filter(ray, Sides::both));
    }
    CHECK(open == 0);
}

TEST_CASE("an annulus is bounded as the disk without its hole, and is left like any flat shape") {
    const Disk whole{ring.center, ring.normal, ring.outer_radius};
    const Box box = bounds(Shape(ring), {}).value(), of_whole = bounds(Shape(whole), {}).value();
    CHECK((box.min == of_whole.min && box.max == of_whole.max));
    CHECK(hull(ring).size() == hull(whole).size());
    CHECK(is_flat(ring));
}
