#include "catch.h"
#include "geometry/every_shape.h"
#include "geometry/verdict.h"
#include "raylab/geometry/filter/moved_origin.h"
#include "raylab/geometry/filter/prepared_flat.h"
#include "raylab/geometry/filter/revolution_filter.h"
#include "raylab/geometry/local_frame.h"
#include "raylab/geometry/placement_at.h"

#include <gmpxx.h>

#include <atomic>
#include <numbers>
#include <variant>

// Flats, cylinders and cones that only translate have filters of their own: they ask the filters of shapes at rest
// about a ray whose origin is seen from where the shape has moved.

using namespace raylab;
using namespace raylab::adversarial;
using raylab::adversarial::Draw;

namespace {

struct Translated {
    Shape shape;
    Affine placement;
    Motion motion;
    Sides sides;
};

// Points on or near the boundary of a shape, in its own coordinates.
struct NearBoundary {
    Draw& draw;

    Vec3d around(const Vec3f& center, const Vec3f& normal, double radius) const {
        const LocalFrame frame = frame_around(glm::normalize(convert<double>(normal)));
        const double turn = draw.one_in(3) ? draw.integer(0, 3) / 4.0 : draw.number(0, 1);
        const double out = radius * (draw.one_in(4) ? draw.number(0, 1.2) : 1);
        return convert<double>(center) + out * (std::cos(2 * std::numbers::pi * turn) * frame.x +
                                                std::sin(2 * std::numbers::pi * turn) * frame.y);
    }
    Vec3d operator()(const Disk& d) const { return around(d.center, d.normal, d.radius); }
    Vec3d operator()(const Annulus& a) const {
        return around(a.center, a.normal, draw.one_in(2) ? a.inner_radius : a.outer_radius);
    }
    Vec3d operator()(const Polygon& polygon) const {
        const auto& v = polygon.vertices;
        const auto i = static_cast<std::size_t>(draw.integer(0, static_cast<int>(v.size()) - 1));
        const double weight = draw.one_in(3) ? 0 : draw.number(0, 1);
        return convert<double>(v[i]) * (1 - weight) + convert<double>(v[(i + 1) % v.size()]) * weight;
    }
    // Of the side a point anywhere or at a rim; the sides' silhouettes are met where the ray goes on.
    Vec3d on_side(const Vec3f& base, const Vec3f& top, double base_radius, double top_radius) const {
        const double s = draw.one_in(2) ? draw.integer(0, 1) : draw.number(-0.1, 1.1);
        const Vec3f at = convert<float>(convert<double>(base) * (1 - s) + convert<double>(top) * s);
        return around(at, top - base, base_radius * (1 - s) + top_radius * s);
    }
    Vec3d operator()(const Cylinder& c) const { return on_side(c.base, c.top, c.radius, c.radius); }
    Vec3d operator()(const Cone& c) const { return on_side(c.base, c.top, c.base_radius, c.top_radius); }
    Vec3d operator()(const auto&) const { return convert<double>(any_point(draw)); }
};

Shape shape_with_filter(Draw& draw) {
    const auto ends = [&] { return draw.one_in(2) ? Ends::open : Ends::capped; };
    for (;;) {
        Shape shape = draw.one_in(8)   ? Shape(any_annulus(draw))
                      : draw.one_in(4) ? Shape(Cylinder{any_point(draw), any_point(draw), any_radius(draw), ends()})
                      : draw.one_in(4)
                          ? Shape(Cone{any_point(draw), any_point(draw), any_radius(draw), any_radius(draw), ends()})
                          : any_shape(draw);
        const auto* cylinder = std::get_if<Cylinder>(&shape);
        const auto* cone = std::get_if<Cone>(&shape);
        if ((cylinder && cylinder->base == cylinder->top) || (cone && cone->base == cone->top)) continue;
        if (cylinder || cone || std::holds_alternative<Plane>(shape) || std::holds_alternative<Disk>(shape) ||
            std::holds_alternative<Annulus>(shape) || std::holds_alternative<Polygon>(shape))
            return shape;
    }
}

Translated translated(Draw& draw) {
    const auto somewhere = [&] { return draw.one_in(3) ? draw.on_lattice(-3, 3) : draw.in_cube(3); };
    return {shape_with_filter(draw), {.translation = somewhere()}, {.translation = somewhere()}, any_sides(draw)};
}

Ray aimed(Draw& draw, const Translated& it, float time) {
    const Vec3d moved = placement_at<double>(it.placement, it.motion, time).translation;
    const Vec3d point = std::visit(NearBoundary{draw}, it.shape) + moved;
    Ray ray = draw.one_in(4) ? Ray{convert<float>(point), draw.lattice_direction(2)} : through(any_point(draw), point);
    ray.time = time;
    return ray;
}

// Multiplies all lengths of a shape.
struct Scaled {
    float by;

    Vec3f operator()(const Vec3f& v) const { return scaled(v, by); }
    Shape operator()(const Plane& p) const { return Plane{(*this)(p.point), p.normal}; }
    Shape operator()(const Disk& d) const { return Disk{(*this)(d.center), d.normal, by * d.radius}; }
    Shape operator()(const Annulus& a) const {
        return Annulus{(*this)(a.center), a.normal, by * a.inner_radius, by * a.outer_radius};
    }
    Shape operator()(Polygon polygon) const {
        for (Vec3f& v : polygon.vertices) v = (*this)(v);
        return polygon;
    }
    Shape operator()(const Cylinder& c) const {
        return Cylinder{(*this)(c.base), (*this)(c.top), by * c.radius, c.ends};
    }
    Shape operator()(const Cone& c) const {
        return Cone{(*this)(c.base), (*this)(c.top), by * c.base_radius, by * c.top_radius, c.ends};
    }
    Shape operator()(const auto& other) const { return other; }
};

// All in another unit of length, which is a power of two, and of time; now and then what moves is of other sizes.
void set_any_exponent(Draw& draw, Translated& it, Ray& ray) {
    const int length = draw.integer(-100, 90), seconds = draw.integer(-30, 30);
    const float by = std::ldexp(1.0f, length);
    it.shape = std::visit(Scaled{by}, it.shape);
    const int other = draw.one_in(3) ? draw.integer(-60, 30) : 0;
    it.placement.translation = scaled(it.placement.translation, by);
    it.motion.translation = scaled(it.motion.translation, std::ldexp(by, other - seconds));
    ray.time = std::ldexp(ray.time, seconds);
    ray.origin = scaled(ray.origin, by);
    ray.direction = scaled(ray.direction, draw.one_in(2) ? by : std::ldexp(1.0f, draw.integer(-120, 100)));
}

FilterVerdict by_filter(const Ray& ray, const Translated& it) {
    const auto& [shape, placement, motion, sides] = it;
    const auto flat = [&](const auto& s) { return PreparedFlat(s).filter(ray, placement, motion, sides); };
    if (const auto* s = std::get_if<Cylinder>(&shape))
        return revolution_filter::decide(ray, *s, placement, motion, sides);
    if (const auto* s = std::get_if<Cone>(&shape)) return revolution_filter::decide(ray, *s, placement, motion, sides);
    if (const auto* s = std::get_if<Plane>(&shape)) return flat(*s);
    if (const auto* s = std::get_if<Disk>(&shape)) return flat(*s);
    if (const auto* s = std::get_if<Annulus>(&shape)) return flat(*s);
    return flat(std::get<Polygon>(shape));
}

struct Seen {
    std::atomic<int> asked = 0, decided = 0;
};

// The filter's verdict, where it has one, and half the time that in a range that ends about the hit.
std::optional<std::string> judge(Draw& draw, Ray ray, const Translated& it, Seen& seen) {
    const auto wrong = [&](const FilterVerdict& verdict) -> std::optional<std::string> {
        if (std::holds_alternative<Undecided>(verdict)) return std::nullopt;
        const auto truth = oracle::intersect(in<double>(ray), it.shape, it.placement, it.motion, ray.time, it.sides);
        auto found = fault(ray, truth, candidate_of(verdict));
        if (found) *found += fmt::format(" for shape {}", it.shape.index());
        return found;
    };
    ++seen.asked;
    const FilterVerdict verdict = by_filter(ray, it);
    if (std::holds_alternative<Undecided>(verdict)) return std::nullopt;
    ++seen.decided;
    if (auto found = wrong(verdict)) return found;
    const auto hit = candidate_of(verdict);
    if (!hit || draw.one_in(2)) return std::nullopt;
    ray.range = tight_range(draw, cast<float>(hit->t));
    return wrong(by_filter(ray, it));
}

std::optional<std::string> at_usual_sizes(Draw& draw, Seen& seen) {
    const Translated it = translated(draw);
    return judge(draw, aimed(draw, it, any_time(draw)), it, seen);
}

std::optional<std::string> at_any_exponent(Draw& draw, Seen& seen) {
    Translated it = translated(draw);
    Ray ray = aimed(draw, it, any_time(draw));
    set_any_exponent(draw, it, ray);
    if (ray.direction == Vec3f(0)) return std::nullopt;
    return judge(draw, ray, it, seen);
}

void check_filters(std::size_t count) {
    Seen usual, extreme;
    CHECK(faults(count / 2, [&](Draw& draw) { return at_usual_sizes(draw, usual); }) == "");
    CHECK(faults(count / 2, [&](Draw& draw) { return at_any_exponent(draw, extreme); }) == "");
    INFO(usual.decided << " of " << usual.asked << ", " << extreme.decided << " of " << extreme.asked);
    CHECK(usual.decided > usual.asked / 2);
    CHECK(extreme.decided > extreme.asked / 5);
}

mpq_class exact_way(const Ray& ray, const Vec3f& point, const Affine& placement, const Motion& motion, int i) {
    const auto exact = [](float x) { return mpq_class(static_cast<double>(x)); };
    return exact(ray.origin[i]) - exact(point[i]) - exact(placement.translation[i]) -
           exact(ray.time) * exact(motion.translation[i]);
}

}  // namespace

TEST_CASE("the way from where a shape has moved to a ray's origin errs by one rounding, and has a float's size") {
    std::atomic<int> found = 0, asked = 0;
    const auto judge = [&](Draw& draw) -> std::optional<std::string> {
        const bool any = draw.one_in(3);
        const auto place = [&] { return any ? draw.anywhere() : draw.one_in(2) ? draw.in_cube(3) : any_point(draw); };
        const Vec3f point = place();
        const Affine placement{.translation = place()};
        const Motion motion{.translation = place()};
        Ray ray{.origin = place(), .direction = {1, 0, 0}};
        ray.time = any ? draw.anything() : any_time(draw);
        // Nearly all cancels.
        if (draw.one_in(2))
            ray.origin = convert<float>(convert<double>(point) + convert<double>(placement.translation) +
                                        double{ray.time} * convert<double>(motion.translation));
        asked += any ? 0 : 1;
        const auto way = origin_from_moved(ray, point, placement, motion);
        if (!way) return std::nullopt;
        found += any ? 0 : 1;
        for (int i = 0; i < 3; ++i) {
            const mpq_class exact = exact_way(ray, point, placement, motion, i);
            const mpq_class error = abs(exact - mpq_class((*way)[i]));
            const bool near = error <= abs(exact) * mpq_class((1 + 0x1p-10) * 0x1p-53);
            const double size = std::abs((*way)[i]);
            if (!near || (size != 0 && !(size >= 0x1p-149 && size < 0x1p130)))
                return fmt::format("coordinate {}: {:a} errs by {:a}: {} less {}", i, (*way)[i], error.get_d(),
                                   words(ray), words(point));
        }
        return std::nullopt;
    };
    CHECK(faults(100'000, judge) == "");
    CHECK(found > asked / 2);
}

TEST_CASE("filters of shapes that translate decide exactly, and most rays near their boundaries") {
    check_filters(40'000);
}

TEST_CASE("a million rays near the boundaries of shapes that translate", "[.million]") { check_filters(1'000'000); }
