#include "raylab/geometry/filter/revolution_filter.h"

#include "raylab/geometry/filter/sphere_filter.h"
#include "raylab/geometry/predicate/revolution_intersection.h"

#include <cmath>

namespace raylab::revolution_filter {

namespace {

using sphere_filter::Approximate, sphere_filter::OfRange;

// p = origin - base and g = top - base carry one rounding a coordinate, which is relative. A sum of products of n
// factors, of less than 120 roundings together, then errs by less than 2^-46 of what it would be if nothing cancelled
// (number/estimate.h), and that is less than the product of the factors' lengths, a cross product counted as sqrt(2)
// times its own (Cauchy).
constexpr double relative = 0x1p-46;

// A quotient whose divisor is known to one part in 2^26 and better: what is divided by its worst case adds less than
// this.
constexpr double outward = 1 + 2 * t_accuracy;

// A ray as the axis sees it, with the squares of the lengths of p and d.
struct RayAboutAxis {
    AxisView<double> axis;
    double from_base, of_direction;

    // The error bound of the square of g's length and of the place.
    double place_error_bound() const { return relative * (from_base + axis.squared_length); }

    // Products stay in range: a factor that is too large makes bounds infinite, which decides nothing.
    bool stays_in_range() const { return axis.squared_length > 0x1p-40 && of_direction > 0x1p-80; }

    bool is_level() const { return !(axis.speed * axis.speed > 0x1p-90 * of_direction * axis.squared_length); }

    // Surely beyond base or top, and going on that way.
    bool leaves_slab() const {
        if (is_level()) return false;
        return axis.speed > 0 ? axis.place - axis.squared_length > place_error_bound()
                              : axis.place < -place_error_bound();
    }
};

// The error bounds of F's coefficients along a ray; of b the square of its bound.
struct ErrorBounds {
    double a, squared_b, c, discriminant;
};

ErrorBounds error_bounds(const RayAboutAxis& look, const Cylinder& cylinder) {
    const double q = look.of_direction, p = look.from_base, l = look.axis.squared_length;
    const double limit = double{cylinder.radius} * cylinder.radius * l;
    return {.a = relative * (2 * q * l),
            .squared_b = relative * relative * (4 * l * l * p * q),
            .c = relative * (2 * p * l + limit),
            .discriminant = relative * (2 * q * l) * (limit + 4 * p * l)};
}

ErrorBounds error_bounds(const RayAboutAxis& look, const Cone& cone) {
    const double q = look.of_direction, p = look.from_base, l = look.axis.squared_length;
    const double base = cone.base_radius, growth = cone.top_radius - base, squared_growth = growth * growth;
    const double width = base * base * l + squared_growth * p;  // the square of L times the radius is below 2 l width
    return {.a = relative * q * l * (2 * l + squared_growth),
            .squared_b = relative * relative * (4 * l * l * q * (2 * l * l * p + width * squared_growth)),
            .c = relative * 2 * l * (p * l + width),
            .discriminant = relative * q * l * l * l * (12 * width + 8 * p * l)};
}

FilterVerdict on_part(const Approximate& at, Part part) {
    return Candidate{.t = at.t, .t_error = at.error, .part = part};
}

bool surely_before(const Approximate& a, const Approximate& b) { return a.t + a.error < b.t - b.error; }

// F(t) = a t^2 + 2 b t + c with a > 0 and two zeros.
struct Crossed {
    const RayAboutAxis& look;
    AlongRay<double> f;
    ErrorBounds error_bound;
    double surd = std::sqrt(f.discriminant), size_of_q = std::abs(f.b) + surd;
    double q_error = (error_bound.discriminant / surd + std::sqrt(error_bound.squared_b)) / size_of_q +
                     4 * unit_roundoff<double>;  // relative

    bool is_well_known() const { return q_error < t_accuracy && error_bound.a < t_accuracy * f.a; }

    Approximate by_q() const {
        const double t = f.c / size_of_q;
        return {t, (std::abs(t) * (q_error + relative) + error_bound.c / size_of_q) * outward};
    }
    Approximate by_a() const {
        const double t = size_of_q / f.a;
        return {t, t * (q_error + relative + error_bound.a / f.a) * outward};
    }
    // One of the two forms of a root cancels.
    Approximate last() const {
        if (!(f.b > 0)) return by_a();
        const Approximate minus = by_q();
        return {-minus.t, minus.error};
    }
};

// The t at which the ray crosses the plane of a cap; absent: the ray is nearly parallel to it.
std::optional<Approximate> at_plane(const RayAboutAxis& look, Part cap) {
    const AxisView<double>& axis = look.axis;
    const double speed = std::abs(axis.speed),
                 error_bound = relative * std::sqrt(look.of_direction * axis.squared_length);
    if (!(error_bound < t_accuracy * speed)) return std::nullopt;
    const double t = (cap == Part::top_cap ? axis.squared_length - axis.place : -axis.place) / axis.speed;
    return Approximate{
        t, ((2 * look.place_error_bound() + std::abs(t) * error_bound) / speed + relative * std::abs(t)) * outward};
}

// Where along the axis the ray crosses the surface without ends.
enum class Level { below_base, between, above_top, unknown };

Level level(const RayAboutAxis& look, const Approximate& at) {
    const double top = look.axis.squared_length, place = look.axis.place + look.axis.speed * at.t;
    const double error_bound = 2 * relative * (look.from_base + 2 * top + at.t * at.t * look.of_direction) +
                               std::abs(look.axis.speed) * at.error * outward;
    if (place > error_bound && top - place > error_bound) return Level::between;
    if (place < -error_bound) return Level::below_base;
    return place - top > error_bound ? Level::above_top : Level::unknown;
}

// A question about a ray, and which of the surfaces it may come to there are to be hit.
struct Question {
    const Ray& ray;
    Ends ends;
    Sides sides;

    bool sees_entries() const { return sees(sides, Sign::negative); }
    bool sees_exits() const { return sees(sides, Sign::positive); }
    OfRange of_range(const Approximate& at) const { return sphere_filter::of_range(at.t, at.error, ray.range); }
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
    const Approximate first = crossed.by_q();
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
FilterVerdict decide_from(const Vec3d& p, const Ray& ray, const S& shape, Sides sides) {
    const Vec3d d = convert<double>(ray.direction), g = convert<double>(shape.top) - convert<double>(shape.base);
    const RayAboutAxis look{view<double>(p, d, g), dot(p, p), dot(d, d)};
    if (!(ray.range.min >= 0) || !look.stays_in_range()) return Undecided{};
    if (look.leaves_slab()) return Miss{};

    const AlongRay<double> f = along(TransformedRay<double>{p, d, ray.range, 1, false}, shape, look.axis);
    const ErrorBounds error_bound = error_bounds(look, shape);
    if (!(f.a > error_bound.a)) return Undecided{};
    const bool outside = f.c > error_bound.c, goes_away = f.b > 0 && f.b * f.b > 4 * error_bound.squared_b;
    if (outside && goes_away) return Miss{};
    if (f.discriminant < -error_bound.discriminant) return Miss{};  // and caps lie where F <= 0
    if (!(f.discriminant > error_bound.discriminant)) return Undecided{};

    const Crossed crossed{look, f, error_bound};
    if (!crossed.is_well_known()) return Undecided{};
    const Question question{ray, shape.ends, sides};
    if (outside) return f.b < 0 ? entry_from_outside(question, crossed) : Undecided{};
    return f.c < -error_bound.c ? from_within(question, crossed) : Undecided{};
}

template <class S>
FilterVerdict decide_at_rest(const Ray& ray, const S& shape, Sides sides) {
    return if_accurate(decide_from(convert<double>(ray.origin) - convert<double>(shape.base), ray, shape, sides));
}

template <class S>
FilterVerdict decide_moved(const Ray& ray, const S& shape, const Affine& placement, const Motion& motion, Sides sides) {
    const auto p = origin_from_moved(ray, shape.base, placement, motion);
    return p ? if_accurate(decide_from(*p, ray, shape, sides)) : Undecided{};
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

}  // namespace raylab::revolution_filter
