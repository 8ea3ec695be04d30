#pragma once

#include "raylab/geometry/filter/moved_origin.h"
#include "raylab/geometry/predicate/accuracy.h"
#include "raylab/geometry/predicate/verdict.h"
#include "raylab/geometry/shapes.h"

#include <cmath>
#include <optional>

// The filter in plain doubles for a ray and a sphere that is not transformed. It is inlined: it serves half of all
// hits.

namespace raylab::sphere_filter {

[[gnu::always_inline]] inline double times(double number, double factor) { return number * factor; }

#include "raylab/geometry/filter/sphere_terms-inl.h"

/// A sphere as it is asked for, made once where many rays ask.
struct Ball {
    explicit Ball(const Sphere& sphere)
        : center(convert<double>(sphere.center)), squared_radius(double{sphere.radius} * sphere.radius) {}
    Ball(const Vec3d& at, double square) : center(at), squared_radius(square) {}

    Vec3d center;
    double squared_radius;
};

/// The relation of a root with an error bound to the range.
enum class OfRange { before, inside, after, unknown };

[[gnu::always_inline]] inline OfRange of_range(double t, double error, const Interval<float>& range) {
    if (t + error < range.min) return OfRange::before;
    if (t - error > range.max) return OfRange::after;
    return t - error > range.min && t + error < range.max ? OfRange::inside : OfRange::unknown;
}

/// A root with a bound of its error.
struct Approximate {
    double t, error;
};

/// Into the sphere or out of it.
enum class Way { in, out };

/// A verdict that fits registers.
struct SphereVerdict {
    enum class What { undecided, missed, hit } what;
    Approximate at = {};  // of a hit
    Way way = Way::in;    // ... the ray goes there
};

[[gnu::always_inline]] inline SphereVerdict accept(const Approximate& hit, Way way) {
    return {is_accurate(hit.t, hit.error) ? SphereVerdict::What::hit : SphereVerdict::What::undecided, hit, way};
}

/// The first of two roots inside the range, the ray going in at the one and out at the other.
template <class Entry, class Exit>
[[gnu::always_inline]] inline SphereVerdict first_of(const Entry& find_entry, const Exit& find_exit,
                                                     const Interval<float>& range, Sides sides) {
    Approximate entry = find_entry();
    const OfRange at_entry = of_range(entry.t, entry.error, range);
    if (at_entry == OfRange::inside && sees(sides, Sign::negative)) return accept(entry, Way::in);
    if (at_entry == OfRange::after) return {SphereVerdict::What::missed};
    if (at_entry == OfRange::unknown) return {SphereVerdict::What::undecided};
    Approximate exit = find_exit();
    const OfRange at_exit = of_range(exit.t, exit.error, range);
    if (at_exit == OfRange::unknown) return {SphereVerdict::What::undecided};
    return at_exit == OfRange::inside && sees(sides, Sign::positive) ? accept(exit, Way::out)
                                                                     : SphereVerdict{SphereVerdict::What::missed};
}

/// The nearest hit inside a ray's range, as far as plain doubles can tell.
[[gnu::always_inline]] inline SphereVerdict decide(const Vec3d& origin, const Vec3d& d, const Interval<float>& range,
                                                   const Ball& sphere, Sides sides) {
    constexpr double u64 = unit_roundoff<double>;
    const Vec3d f = origin - sphere.center;
    const double a = dot(d, d);
    const auto [b, distance, c, c_error, discriminant, discriminant_error] =
        sphere_terms(d.x, d.y, d.z, f.x, f.y, f.z, a, sphere.squared_radius);
    // Outside and on the way out: both roots have the sign of -b.
    const bool outward = b > 0 && b * b > 26 * u64 * u64 * a * distance;
    if (outward && c > c_error && range.min >= 0) return {SphereVerdict::What::missed};
    if (discriminant < -discriminant_error) return {SphereVerdict::What::missed};
    if (!(discriminant > discriminant_error)) return {SphereVerdict::What::undecided};

    // The stable roots: t = q / a and t = c / q with q = -(b + sign(b) sqrt(discriminant)). The square root errs by
    // less than its argument's error over itself; of which b's is less than a tenth, since the root is at most sqrt(a)
    // r and (f.f + r^2) / r at least 2 |f|.
    const double surd = std::sqrt(discriminant);
    const double q = b > 0 ? -b - surd : surd - b;
    const double inverse = 1 / (std::abs(q) * surd);
    const double q_error = 1.25 * discriminant_error * inverse + 5 * u64;  // relative
    // A t cannot be better than q; and below this, dividing by q instead of its worst case adds less than 2^-25 of it.
    if (!(q_error < t_accuracy)) return {SphereVerdict::What::undecided};
    const auto by_a = [&]() -> Approximate {
        const double t = q / a;
        return {t, std::abs(t) * (q_error + 5 * u64)};
    };
    const auto by_q = [&]() -> Approximate {
        const double t = c / q;
        return {t, (std::abs(t) * (q_error + 5 * u64) + c_error * surd * inverse) * (1 + 2 * t_accuracy)};
    };
    return b > 0 ? first_of(by_a, by_q, range, sides) : first_of(by_q, by_a, range, sides);
}

[[gnu::always_inline]] inline SphereVerdict decide(const Ray& ray, const Sphere& sphere, Sides sides) {
    return decide(convert<double>(ray.origin), convert<double>(ray.direction), ray.range, Ball(sphere), sides);
}

/// The same for a sphere that has only translated, where it stands at the ray's time.
inline SphereVerdict decide(const Ray& ray, const Sphere& sphere, const Affine& placement, const Motion& motion,
                            Sides sides) {
    const auto f = origin_from_moved(ray, sphere.center, placement, motion);
    if (!f) return {SphereVerdict::What::undecided};
    const Ball about_origin(Vec3d(0), double{sphere.radius} * sphere.radius);
    return decide(*f, convert<double>(ray.direction), ray.range, about_origin, sides);
}

inline FilterVerdict as_filter_verdict(const SphereVerdict& verdict) {
    if (verdict.what == SphereVerdict::What::missed) return Miss{};
    if (verdict.what == SphereVerdict::What::hit) return Candidate{verdict.at.t, verdict.at.error};
    return Undecided{};
}

}  // namespace raylab::sphere_filter
