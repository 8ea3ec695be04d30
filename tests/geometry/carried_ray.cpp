#include "raylab/geometry/filter/carried_ray.h"
#include "catch.h"
#include "geometry/every_shape.h"
#include "geometry/verdict.h"
#include "raylab/geometry/filter/ellipsoid_filter.h"
#include "raylab/geometry/filter/prepared_flat.h"
#include "raylab/geometry/filter/revolution_filter.h"
#include "raylab/number/dyadic.h"

#include <array>
#include <atomic>

using namespace raylab;
using namespace raylab::adversarial;

namespace {

// What doubles say of a shape where it is placed; absent: no filter knows the shape.
struct CarriedFilter {
    const Ray& ray;
    const CarryBack carry_back;
    const Sides sides;

    FilterVerdict operator()(const Sphere& sphere) const { return about_center(sphere); }
    FilterVerdict operator()(const Ellipsoid& ellipsoid) const { return about_center(ellipsoid); }
    FilterVerdict operator()(const Cylinder& cylinder) const { return of_revolution(cylinder); }
    FilterVerdict operator()(const Cone& cone) const { return of_revolution(cone); }
    FilterVerdict operator()(const Disk& disk) const { return flat(disk); }
    FilterVerdict operator()(const Annulus& annulus) const { return flat(annulus); }
    FilterVerdict operator()(const Plane& plane) const { return flat(plane); }
    FilterVerdict operator()(const Polygon& polygon) const { return flat(polygon); }
    FilterVerdict operator()(const auto&) const { return Undecided{}; }

private:
    FilterVerdict about_center(const auto& shape) const {
        const auto carried = carry_back(ray, convert<double>(shape.center));
        if (!carried) return Undecided{};
        return sphere_filter::as_filter_verdict(ellipsoid_filter::decide(*carried, shape, sides));
    }
    FilterVerdict of_revolution(const auto& shape) const {
        const auto carried = carry_back(ray, convert<double>(shape.base));
        return carried ? revolution_filter::decide(*carried, shape, sides) : Undecided{};
    }
    FilterVerdict flat(const auto& shape) const {
        const PreparedFlat prepared(shape);
        const auto carried = carry_back(ray, prepared.point());
        return carried ? prepared.filter(*carried, sides) : Undecided{};
    }
};

struct Seen {
    std::atomic<int> asked = 0, decided = 0, hit = 0;  // by several threads
};

std::optional<std::string> judge(const Ray& ray, const Shape& shape, const Affine& placement, Sides sides, Seen& seen) {
    const FilterVerdict verdict = std::visit(CarriedFilter{ray, CarryBack(placement), sides}, shape);
    ++seen.asked;
    if (std::holds_alternative<Undecided>(verdict)) return std::nullopt;
    ++seen.decided;
    seen.hit += std::holds_alternative<Candidate>(verdict);
    auto wrong = fault(ray, oracle::intersect(in<double>(ray), shape, placement, sides), candidate_of(verdict));
    if (wrong) *wrong += fmt::format(" for shape {}", shape.index());
    return wrong;
}

Affine rotated(Draw& draw) {
    const Vec3d by = convert<double>(draw.in_cube(3));
    return AffineSteps::rotate(convert<double>(draw.lattice_direction(3)), draw.number(0, 360))
        .then(AffineSteps::translate(by))
        .rounded();
}

Vec3f image(const Affine& placement, const Vec3f& v) {
    return placement.columns[0] * v.x + placement.columns[1] * v.y + placement.columns[2] * v.z;
}

// Two axes lie so near to each other that carrying back loses much.
Affine flattened(Draw& draw) {
    Affine placement = rotated(draw);
    const float part = std::ldexp(1.0f, -draw.integer(2, 12));
    placement.columns[2] = placement.columns[0] + placement.columns[2] * part;
    return placement;
}

// A shape on whole numbers, and a ray on whole numbers that just touches it: a tangent, or through a rim or an edge.
struct Touched {
    Shape shape;
    Vec3f origin, direction;
};

Touched touched(Draw& draw) {
    const Vec3f at = draw.on_lattice(-9, 9);
    const auto whole = [&](int low, int high) { return cast<float>(draw.integer(low, high)); };
    const Ends ends = draw.one_in(2) ? Ends::open : Ends::capped;
    const float along = whole(1, 9);
    // (3, 4) and (4, -3) are five long, and perpendicular.
    const Vec3f spoke{3, 4, 0}, tangent{4, -3, 0}, up{0, 0, 1};
    switch (draw.integer(0, 7)) {
        case 0:
            return {Sphere{at, 5}, at + spoke - along * (tangent + whole(-3, 3) * up), tangent + whole(-3, 3) * up};
        case 1: {
            const Vec3f way = tangent + whole(-2, 2) * up;
            return {Cylinder{at - 40.0f * up, at + 40.0f * up, 5, ends}, at + spoke - along * way, way};
        }
        case 2: {  // through a rim from above
            const Vec3f way{whole(-2, 2), whole(-2, 2), -1};
            return {Cylinder{at - 7.0f * up, at, 5, ends}, at + spoke - along * way, way};
        }
        case 3: {
            const Vec3f way{whole(-2, 2), whole(-2, 2), -1};
            return {Disk{at, up, 5}, at + spoke - along * way, way};
        }
        case 4: {
            const Vec3f way{whole(-2, 2), whole(-2, 2), -1};
            return {Annulus{at, up, 5, 9}, at + spoke - along * way, way};
        }
        case 5: {  // twice as wide along x: (6, 4, 0) is on it, and (8, -3, 0) touches it there
            const Vec3f way = Vec3f{8, -3, 0} + whole(-3, 3) * up;
            return {Ellipsoid{at, {10, 5, whole(1, 9)}}, at + Vec3f{6, 4, 0} - along * way, way};
        }
        case 6: {  // through an edge
            const Vec3f way{whole(-2, 2), whole(-2, 2), -1};
            const Polygon polygon{{at, at + Vec3f{6, 8, 0}, at + Vec3f{-5, 9, 0}}};
            return {polygon, at + spoke - along * way, way};
        }
        default: {  // a cone's generator has slope 5 / 10: crossed at half its height
            const Vec3f way = tangent + whole(-2, 2) * up;
            return {Cone{at - 10.0f * up, at + 10.0f * up, 10, 0, ends}, at + spoke - along * way, way};
        }
    }
}

}  // namespace

TEST_CASE("what is said of a ray that is carried back to a placed shape is true, and most rays are decided") {
    Seen anywhere, usual, lossy;
    const auto judge_any = [&](Draw& draw, const Affine& placement, Seen& seen) {
        const Object target = object_of_every_kind(draw);
        const Vec3d at = transform_point(placement, convert<double>(any_point(draw)));
        Ray ray = through(any_point(draw), at);
        if (draw.one_in(4)) ray.range = {draw.uniform(0, 1), draw.uniform(1, 3)};
        return judge(ray, target.shape, placement, target.sides, seen);
    };
    CHECK(faults(20'000, [&](Draw& draw) { return judge_any(draw, any_placement(draw), anywhere); }) == "");
    CHECK(faults(20'000, [&](Draw& draw) { return judge_any(draw, rotated(draw), usual); }) == "");
    // Aimed where the shape was made: what is carried back is then short beside what rounding did to it.
    const auto judge_flattened = [&](Draw& draw) {
        const Object target = object_of_every_kind(draw);
        const Affine placement = flattened(draw);
        const Vec3f from = draw.in_cube(3), way = any_point(draw) - from;
        return judge({image(placement, from) + placement.translation, image(placement, way)}, target.shape, placement,
                     target.sides, lossy);
    };
    CHECK(faults(40'000, judge_flattened) == "");
    CHECK(usual.decided > usual.asked / 3);  // of a third of all kinds nothing is known beforehand
    CHECK(usual.hit > usual.asked / 20);
    CHECK(lossy.hit > lossy.asked / 100);
}

TEST_CASE("of a ray that just touches a placed shape nothing wrong is said, however rounding falls") {
    Seen seen;
    const auto judge_touched = [&](Draw& draw) -> std::optional<std::string> {
        Affine placement{.columns = {draw.on_lattice(-7, 7), draw.on_lattice(-7, 7), draw.on_lattice(-7, 7)},
                         .translation = draw.on_lattice(-99, 99)};
        if (is_singular(placement)) return std::nullopt;
        const Touched t = touched(draw);  // all is small whole numbers, and so exact
        const Ray ray{image(placement, t.origin) + placement.translation, image(placement, t.direction)};
        return judge(ray, t.shape, placement, any_sides(draw), seen);
    };
    CHECK(faults(30'000, judge_touched) == "");
    CHECK(seen.asked > 0);
}

TEST_CASE("a ray is carried back within what it is said to be off, at all sizes") {
    std::atomic<int> known = 0, asked = 0;
    const auto off_by = [&](Draw& draw) -> std::optional<std::string> {
        Affine placement = draw.one_in(3) ? any_placement(draw) : draw.one_in(2) ? rotated(draw) : flattened(draw);
        const float by = cast<float>(std::ldexp(1, draw.integer(-30, 30)));
        for (Vec3f& column : placement.columns) column = scaled(column, by);
        if (is_singular(placement)) return std::nullopt;
        const Vec3f from = draw.in_cube(1);
        const Vec3f near = image(placement, from) + placement.translation;
        const float away = std::ldexp(1.0f, -draw.integer(0, 30));
        const Ray ray{draw.one_in(2) ? draw.in_cube(10) : near + draw.in_cube(away), draw.in_cube(1)};
        const auto carried = CarryBack(placement)(ray, convert<double>(from));
        ++asked;
        if (!carried) return std::nullopt;
        ++known;
        // Exactly, times the determinant: adj(A) v - det(A) (what is said of it).
        const auto x = convert<Dyadic>(placement.columns[0]), y = convert<Dyadic>(placement.columns[1]),
                   z = convert<Dyadic>(placement.columns[2]);
        const std::array<Vec3<Dyadic>, 3> adjugate{cross(y, z), cross(z, x), cross(x, y)};
        const Dyadic determinant = dot(x, adjugate[0]);
        const auto is_off = [&](const Vec3<Dyadic>& v, const Vec3f& seen_from, const Vec3d& said) {
            const Vec3<Dyadic> told = convert<Dyadic>(said), point = convert<Dyadic>(seen_from);
            const Vec3<Dyadic> error{dot(adjugate[0], v) - determinant * (told.x + point.x),
                                     dot(adjugate[1], v) - determinant * (told.y + point.y),
                                     dot(adjugate[2], v) - determinant * (told.z + point.z)};
            const Dyadic allowed = determinant * Dyadic(CarriedRay::off);
            return sign(dot(error, error) - allowed * allowed * dot(told, told)) == Sign::positive;
        };
        if (is_off(convert<Dyadic>(ray.origin) - convert<Dyadic>(placement.translation), from, carried->origin))
            return "the origin is farther off: " + words(ray);
        if (is_off(convert<Dyadic>(ray.direction), {0, 0, 0}, carried->direction))
            return "the direction is farther off: " + words(ray);
        return std::nullopt;
    };
    CHECK(faults(10'000, off_by) == "");
    CHECK(known > asked / 3);
}
