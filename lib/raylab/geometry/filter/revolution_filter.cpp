#include "raylab/geometry/filter/revolution_filter.h"

#include "raylab/geometry/filter/moved_origin.h"
#include "raylab/geometry/filter/quadric_roots.h"
#include "raylab/geometry/predicate/revolution_intersection.h"

#include <cmath>

namespace raylab::revolution_filter {

namespace {

using namespace quadric_filter;
using sphere_filter::OfRange;

// A cross product counts as sqrt(2) times the product of its factors' lengths (Cauchy).

// A ray as the axis sees it, with the squares of the lengths of p and d.
struct RayAboutAxis {
    AxisView<double> axis;
    double from_base, of_direction;
    double relative;  // the error of a product of factors, over that of their lengths

    // The error bound of the square of g's length and of the place.
    double place_error_bound() const { return relative * (from_base + axis.squared_length); }

    // Products stay in range: a factor that is too large makes bounds infinite, which decides nothing.
    bool stays_in_range() const { return axis.squared_length > 0x1p-40 && of_direction > 0x1p-80; }

    bool is_level() const {
        return !(axis.speed * axis.speed > 4 * relative * relative * of_direction * axis.squared_length);
    }

    // Surely beyond base or top, and going on that way.
    bool leaves_slab() const {
        if (is_level()) return false;
        return axis.speed > 0 ? axis.place - axis.squared_length > place_error_bound()
                              : axis.place < -place_error_bound();
    }
};

ErrorBounds error_bounds(const RayAboutAxis& look, const Cylinder& cylinder) {
    const double q = look.of_direction, p = look.from_base, l = look.axis.squared_length;
    const double limit = double{cylinder.radius} * cylinder.radius * l, relative = look.relative;
    return {.a = relative * (2 * q * l),
            .squared_b = relative * relative * (4 * l * l * p * q),
            .c = relative * (2 * p * l + limit),
            .discriminant = relative * (2 * q * l) * (limit + 4 * p * l)};
}

ErrorBounds error_bounds(const RayAboutAxis& look, const Cone& cone) {
    const double q = look.of_direction, p = look.from_base, l = look.axis.squared_length;
    const double base = cone.base_radius, growth = cone.top_radius - base, squared_growth = growth * growth,
                 relative = look.relative;
    const double width = base * base * l + squared_growth * p;  // the square of L times the radius is below 2 l width
    return {.a = relative * q * l * (2 * l + squared_growth),
            .squared_b = relative * relative * (4 * l * l * q * (2 * l * l * p + width * squared_growth)),
            .c = relative * 2 * l * (p * l + width),
            .discriminant = relative * q * l * l * l * (12 * width + 8 * p * l)};
}

FilterVerdict on_part(const Approximate& at, Part part) {
    if (!is_accurate(at.t, at.error)) return Undecided{};
    return Candidate{.t = at.t, .t_error = at.error, .part = part};
}

// F along a ray as the axis sees it, with two zeros.
struct Crossed : Roots {
    const RayAboutAxis& look;
};

// The t at which the ray crosses the plane of a cap; absent: the ray is nearly parallel to it.
std::optional<Approximate> at_plane(const RayAboutAxis& look, Part cap) {
    const AxisView<double>& axis = look.axis;
    const double speed = std::abs(axis.speed),
                 error_bound = look.relative * std::sqrt(look.of_direction * axis.squared_length);
    if (!(error_bound < t_accuracy * speed)) return std::nullopt;
    const double t = (cap == Part::top_cap ? axis.squared_length - axis.place : -axis.place) / axis.speed;
    return Approximate{
        t,
        ((2 * look.place_error_bound() + std::abs(t) * error_bound) / speed + look.relative * std::abs(t)) * outward};
}

// Where along the axis the ray crosses the surface without ends.
enum class Level { below_base, between, above_top, unknown };

Level level(const RayAboutAxis& look, const Approximate& at) {
    const double top = look.axis.squared_length, place = look.axis.place + look.axis.speed * at.t;
    const double error_bound = 2 * look.relative * (look.from_base + 2 * top + at.t * at.t * look.of_direction) +
                               std::abs(look.axis.speed) * at.error * outward;
    if (place > error_bound && top - place > error_bound) return Level::between;
    if (place < -error_bound) return Level::below_base;
    return place - top > error_bound ? Level::above_top : Level::unknown;
}

// A question about a ray, and which of the surfaces it may come to there are to be hit.
struct Question {
    const Interval<float>& range;
    Ends ends;
    Sides sides;

    bool sees_entries() const { return sees(sides, Sign::negative); }
    bool sees_exits() const { return sees(sides, Sign::positive); }
    OfRange of_range(const Approximate& at) const { return sphere_filter::of_range(at.t, at.error, range); }
};

// The ray is inside the surface without ends, and comes to nothing before it leaves that: F < 0 between the crossings
// and nowhere else, and a cap is where its plane has F <= 0.
FilterVerdict exit_by_side(const Question& question, const Crossed& crossed) {
    if (!question.sees_exits()) return Miss{};
    const Approximate last = crossed.last();
    const OfRange in_range = question.of_range(last);
    if (in_range == OfRange::unknown) return Undecided{};
    const Level at = level(crossed.look, last);
    if (at == Level::unknown) return Undecided{};
    return in_range == OfRange::inside && at == Level::between ? on_part(last, Part::side) : FilterVerdict(Miss{});
}

// The ray comes to the surface without ends beyond a cap's plane, or starts there inside of it: it passes the cap, or
// the opening, or misses all.
FilterVerdict entry_by_end(const Question& question, const Crossed& crossed, const std::optional<Approximate>& first,
                           Part cap) {
    const RayAboutAxis& look = crossed.look;
    if (look.is_level()) return Undecided{};
    if ((look.axis.speed < 0) == (cap == Part::base_cap)) return Miss{};
    if (question.ends == Ends::open) return exit_by_side(question, crossed);
    const auto at = at_plane(look, cap);
    if (!at || !question.sees_entries()) return Undecided{};
    const Approximate last = crossed.last();
    if (surely_before(last, *at)) return Miss{};
    const bool between = (!first || surely_before(*first, *at)) && surely_before(*at, last);
    return between && question.of_range(*at) == OfRange::inside ? on_part(*at, cap) : Undecided{};
}

// The ray starts outside and hits where it first crosses the surface.
FilterVerdict entry_from_outside(const Question& question, const Crossed& crossed) {
    const Approximate first = crossed.first();
    const OfRange in_range = question.of_range(first);
    if (in_range == OfRange::after) return Miss{};
    if (in_range != OfRange::inside) return Undecided{};
    switch (level(crossed.look, first)) {
        case Level::between:
            if (question.sees_entries()) return on_part(first, Part::side);
            return question.ends == Ends::open ? exit_by_side(question, crossed) : Undecided{};
        case Level::below_base:
            return entry_by_end(question, crossed, first, Part::base_cap);
        case Level::above_top:
            return entry_by_end(question, crossed, first, Part::top_cap);
        case Level::unknown:
            break;
    }
    return Undecided{};
}

// The ray starts inside the shape itself, and hits where it leaves it: by a cap where it has surely passed that before
// it leaves the surface without ends.
FilterVerdict exit_from_within(const Question& question, const Crossed& crossed) {
    if (!question.sees_exits()) return Miss{};
    const Level at = level(crossed.look, crossed.last());
    if (question.ends == Ends::open || at == Level::between) return exit_by_side(question, crossed);
    if (at == Level::unknown) return Undecided{};
    const Part cap = at == Level::below_base ? Part::base_cap : Part::top_cap;
    const auto plane = at_plane(crossed.look, cap);
    const bool inside = plane && question.of_range(*plane) == OfRange::inside;
    return inside ? on_part(*plane, cap) : FilterVerdict(Undecided{});
}

// The ray starts inside the surface without ends.
FilterVerdict from_within(const Question& question, const Crossed& crossed) {
    const RayAboutAxis& look = crossed.look;
    const double error_bound = look.place_error_bound(), place = look.axis.place,
                 from_top = look.axis.squared_length - place;
    if (place < -error_bound) return entry_by_end(question, crossed, std::nullopt, Part::base_cap);
    if (from_top < -error_bound) return entry_by_end(question, crossed, std::nullopt, Part::top_cap);
    return place > error_bound && from_top > error_bound ? exit_from_within(question, crossed) : Undecided{};
}

// The ray begins at p, as seen from the shape's base.
template <class S>
FilterVerdict decide_from(const Vec3d& p, const Vec3d& d, const Interval<float>& range, const S& shape, Sides sides,
                          double relative) {
    const Vec3d g = convert<double>(shape.top) - convert<double>(shape.base);
    const RayAboutAxis look{view<double>(p, d, g), dot(p, p), dot(d, d), relative};
    if (!(range.min >= 0) || !look.stays_in_range()) return Undecided{};
    if (look.leaves_slab()) return Miss{};

    const AlongRay<double> f = along(TransformedRay<double>{p, d, range, 1, false}, shape, look.axis);
    const ErrorBounds error_bound = error_bounds(look, shape);
    if (!(f.a > error_bound.a)) return Undecided{};
    if (surely_misses(f, error_bound)) return Miss{};  // and caps lie where F <= 0
    if (!(f.discriminant > error_bound.discriminant)) return Undecided{};

    const Crossed crossed{{f, error_bound, relative}, look};
    if (!crossed.are_well_known()) return Undecided{};
    const Question question{range, shape.ends, sides};
    if (begins_outside(f, error_bound)) return f.b < 0 ? entry_from_outside(question, crossed) : Undecided{};
    return f.c < -error_bound.c ? from_within(question, crossed) : Undecided{};
}

template <class S>
FilterVerdict decide_at_rest(const Ray& ray, const S& shape, Sides sides) {
    return decide_from(convert<double>(ray.origin) - convert<double>(shape.base), convert<double>(ray.direction),
                       ray.range, shape, sides, relative_at_rest);
}

template <class S>
FilterVerdict decide_moved(const Ray& ray, const S& shape, const Affine& placement, const Motion& motion, Sides sides) {
    const auto p = origin_from_moved(ray, shape.base, placement, motion);
    if (!p) return Undecided{};
    return decide_from(*p, convert<double>(ray.direction), ray.range, shape, sides, relative_at_rest);
}

template <class S>
FilterVerdict decide_carried(const CarriedRay& ray, const S& shape, Sides sides) {
    return decide_from(ray.origin, ray.direction, ray.range, shape, sides, relative_carried);
}

}  // namespace

FilterVerdict decide(const Ray& ray, const Cylinder& cylinder, Sides sides) {
    return decide_at_rest(ray, cylinder, sides);
}
FilterVerdict decide(const Ray& ray, const Cone& cone, Sides sides) { return decide_at_rest(ray, cone, sides); }

FilterVerdict decide(const Ray& ray, const Cylinder& cylinder, const Affine& placement, const Motion& motion,
                     Sides sides) {
    return decide_moved(ray, cylinder, placement, motion, sides);
}
FilterVerdict decide(const Ray& ray, const Cone& cone, const Affine& placement, const Motion& motion, Sides sides) {
    return decide_moved(ray, cone, placement, motion, sides);
}

FilterVerdict decide(const CarriedRay& ray, const Cylinder& cylinder, Sides sides) {
    return decide_carried(ray, cylinder, sides);
}
FilterVerdict decide(const CarriedRay& ray, const Cone& cone, Sides sides) { return decide_carried(ray, cone, sides); }

}  // namespace raylab::revolution_filter
