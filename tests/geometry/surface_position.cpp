#include "catch.h"
#include "geometry/verdict.h"

#include "raylab/geometry/intersect/nearest.h"
#include "raylab/geometry/predicate/intersection.h"
#include "raylab/geometry/surface/surface_position.h"
#include "raylab/number/dyadic.h"

#include <memory>

using namespace raylab;
using adversarial::Draw;

namespace {

// The exact side of the surface that a point is on: the sign of the surface's function there.
struct SideOf {
    TransformedRay<Dyadic> at;  // a ray of no interest but for its origin
    Part part;
    std::uint32_t triangle;
    mutable Signs<Dyadic> signs = {};

    Sign of_plane(const Vec3<Dyadic>& point, const Vec3<Dyadic>& normal) const {
        return sign(dot(normal, at.origin - point));
    }

    Sign operator()(const Plane& plane) const { return of_plane(at.point(plane.point), convert<Dyadic>(plane.normal)); }
    Sign operator()(const Disk& disk) const { return of_plane(at.point(disk.center), convert<Dyadic>(disk.normal)); }
    Sign operator()(const Annulus& annulus) const {
        return of_plane(at.point(annulus.center), convert<Dyadic>(annulus.normal));
    }
    Sign operator()(const Polygon& polygon) const {
        return of_plane(at.point(polygon.vertices.front()), newell_normal<Dyadic>(polygon));
    }
    Sign operator()(const Triangle& t) const {
        const auto a = convert<Dyadic>(t.a);
        return of_plane(at.point(t.a), cross(convert<Dyadic>(t.b) - a, convert<Dyadic>(t.c) - a));
    }
    Sign operator()(const std::shared_ptr<const Mesh>& mesh) const { return (*this)(mesh->triangle(triangle)); }
    Sign operator()(const Sphere& sphere) const { return sign(along(at, sphere).c); }
    Sign operator()(const Ellipsoid& ellipsoid) const { return sign(along(at, ellipsoid).c); }
    template <class Revolved>
    Sign operator()(const Revolved& shape) const {
        const auto axis = convert<Dyadic>(shape.top) - convert<Dyadic>(shape.base);
        if (part == Part::base_cap) return of_plane(at.point(shape.base), axis);
        if (part == Part::top_cap) return of_plane(at.point(shape.top), axis);
        return sign(along(at, shape, view(at, shape.base, shape.top)).c);
    }
};

// A shape's place at a time.
struct Stands {
    Affine placement;
    std::optional<Motion> motion = {};
    float time = 0;

    const Motion* moves() const { return motion ? &*motion : nullptr; }
    Vec3d place_of(const Vec3d& p) const {
        return transform_point(motion ? rounded_placement(placement, *motion, time) : placement, p);
    }
};

Sign side(const Vec3d& point, const Hit& hit, const Shape& shape, const Stands& stands) {
    const auto from = convert<Dyadic>(point), along = convert<Dyadic>(Vec3d{1, 0, 0});
    const auto carried = [&](const PlacementAt<Dyadic>& at) {
        return carried_back<Dyadic>(from - at.translation, along, {0, 1}, at.columns[0], at.columns[1], at.columns[2]);
    };
    const auto local = stands.motion ? carried(placement_at<Dyadic>(stands.placement, *stands.motion, stands.time))
                                     : transformed_ray<Dyadic>(from, along, {0, 1}, stands.placement);
    return std::visit(SideOf{local, hit.part, hit.primitive.part}, shape);
}

Shape any_shape(Draw& draw, const Vec3f& at) {
    const auto near = [&] { return at + draw.in_cube(1); };
    const Ends ends = draw.one_in(2) ? Ends::capped : Ends::open;
    switch (draw.integer(0, 10)) {
        case 0:
            return Sphere{at, draw.uniform(0.01, 1)};
        case 1:
            return Ellipsoid{at, {draw.uniform(0.01, 1), draw.uniform(0.1, 1), 1}};
        case 2:
            return Cylinder{near(), near(), draw.uniform(0.01, 1), ends};
        case 3:
            return Cone{near(), near(), draw.uniform(0.1, 2), draw.one_in(2) ? 0.0f : draw.uniform(0, 1), ends};
        case 4:
            return Paraboloid{near(), near(), draw.uniform(0.01, 2), ends};
        case 5:
            return Hyperboloid{near(), near(), draw.uniform(0.001, 1), draw.uniform(0.001, 2), ends};
        case 6:
            return Plane{at, draw.in_cube(3)};
        case 7:
            return Disk{at, draw.in_cube(3), 1};
        case 8: {  // thin: the areas that make its normal nearly cancel
            const Vec3f a = draw.one_in(3) ? draw.in_cube(1e-9) : near(), along = draw.in_cube(1),
                        across = adversarial::scaled(draw.in_cube(1), draw.one_in(2) ? 1e-4f : 1.0f);
            return Polygon{{a, a + along, a + along + across, a + across}};
        }
        case 9:
            return Annulus{at, draw.in_cube(3), draw.uniform(0.01, 1), 2};
        default:
            return Triangle{draw.one_in(3) ? draw.in_cube(1e-3) : near(), near(), near()};
    }
}

Affine gentle_placement(Draw& draw) {
    Affine affine;
    if (!draw.one_in(2)) return affine;
    const double size = draw.one_in(3) ? std::pow(10, draw.number(-3, 6)) : 1;
    for (Vec3f& column : affine.columns) column = draw.in_cube(2 * size);
    affine.translation = draw.in_cube(draw.one_in(2) ? 1 : 1000);
    return affine;
}

// A place where a shape is thin, if there is one: an apex, a waist, the axis.
std::optional<Vec3d> thin_place(const Shape& shape, Draw& draw) {
    return std::visit(
        [&]<class S>(const S& s) -> std::optional<Vec3d> {
            if constexpr (SurfaceOfRevolution<S>)
                return convert<double>(s.base) +
                       (convert<double>(s.top) - convert<double>(s.base)) * (0.5 * draw.integer(0, 2));
            else
                return std::nullopt;
        },
        shape);
}

// The fault of the surface position of a hit; absent: none.
std::optional<std::string> fault_of(const Ray& ray, const Hit& hit, const Shape& shape, const Stands& stands) {
    const auto [point, error, normal] = surface_position(ray, hit, shape, stands.placement, stands.moves());
    if (!std::isfinite(normal.x)) return std::nullopt;
    // A surface lies between two points of different sides; about an apex those need not be on the normal.
    const Sign here = side(point, hit, shape, stands);
    for (const Vec3d& away : {normal, -normal, Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}, Vec3d{-1, 0, 0},
                              Vec3d{0, -1, 0}, Vec3d{0, 0, -1}})
        if (here == Sign::zero || side(point + away * error, hit, shape, stands) != here) return std::nullopt;
    return fmt::format("no surface within {:g} of {:a} {:a} {:a}, shape {}, {}placed, {}", error, point.x, point.y,
                       point.z, shape.index(), stands.placement.is_identity() ? "not " : "", adversarial::words(ray));
}

// The same of where the ray hits, if it does.
std::optional<std::string> fault_at_hit(const Ray& ray, const Shape& shape, const Stands& stands) {
    DecisionCounts decisions;
    const Target placed{&shape, 0, &stands.placement, Sides::both, stands.moves()};
    const auto hit_found = intersect(ray, placed, decisions);
    if (!hit_found) return std::nullopt;
    return fault_of(ray,
                    {.t = hit_found->t, .primitive = {}, .u = hit_found->u, .v = hit_found->v, .part = hit_found->part},
                    shape, stands);
}

// An end of its motion of which the numbers cancel is as good as any.
Stands gentle_stand(Draw& draw) {
    const Affine begin = gentle_placement(draw);
    if (draw.one_in(2)) return {begin};
    Stands stands{begin, Motion{.translation = draw.in_cube(10)}, draw.uniform(0, 2)};
    if (draw.one_in(2))
        for (Vec3f& column : stands.motion->columns) column = draw.in_cube(0.5);
    return stands;
}

std::optional<std::string> fault(Draw& draw) {
    const Vec3f at = draw.in_cube(draw.one_in(2) ? 0.1 : std::pow(10, draw.number(0, 5)));
    const Shape shape = any_shape(draw, at);
    const Stands stands = gentle_stand(draw);
    if (is_singular(stands.placement)) return std::nullopt;
    const auto thin = draw.one_in(2) ? thin_place(shape, draw) : std::nullopt;
    const Vec3d aim = thin ? *thin + convert<double>(draw.in_cube(std::pow(10, draw.number(-6, -1))))
                           : convert<double>(at + draw.in_cube(0.5));
    const Vec3d target = stands.place_of(aim);
    const Vec3f eye = convert<float>(target + convert<double>(draw.in_cube(std::pow(10, draw.number(0, 6)))));
    Ray ray = adversarial::through(eye, target);
    ray.time = stands.time;
    return fault_at_hit(ray, shape, stands);
}

}  // namespace

TEST_CASE("a hit point put back on its surface is no further from it than its error bound says") {
    CHECK(adversarial::faults(100'000, fault) == "");
}

TEST_CASE(
    "a thin polygon's plane, which rounding tilts, is no further from the point on it than the error bound says") {
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        // Near the first vertex numbers are so small that they are lost where they are taken off the others.
        const Vec3f a = draw.in_cube(1e-9), along = draw.in_cube(1),
                    across = adversarial::scaled(draw.in_cube(1), draw.uniform(1e-6, 1e-3));
        const Polygon thin{{a, a + along, a + along + across, a + across}};
        const Vec3d target =
            convert<double>(along) * draw.number(0.2, 0.8) + convert<double>(across) * draw.number(0.2, 0.8);
        return fault_at_hit(adversarial::through(convert<float>(target) + draw.in_cube(1), target), thin, {});
    };
    CHECK(adversarial::faults(5'000, judge) == "");
}

TEST_CASE("a point that is moved far from a cone's axis is no further from the side than its error bound says") {
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        const Cone cone{draw.in_cube(1), draw.in_cube(1), draw.uniform(0.1, 2), 0};
        const Vec3d base = convert<double>(cone.base), axis = convert<double>(cone.top) - base;
        const Ray from_axis{convert<float>(base + axis * draw.number(0.1, 0.9)),
                            {0, 0, 1}};  // but for its rounding to floats
        return fault_of(from_axis, {.t = 0, .primitive = {}}, cone, {});
    };
    CHECK(adversarial::faults(2'000, judge) == "");
}
