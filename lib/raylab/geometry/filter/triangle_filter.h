#pragma once

#include "raylab/geometry/predicate/accuracy.h"
#include "raylab/geometry/predicate/verdict.h"
#include "raylab/geometry/shapes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

// The filter in plain doubles for a ray and a triangle, with which intersect() begins. (bvh8_locate-inl.h computes the
// same volumes, edges side by side, for a triangle that is known to be hit, and bounds their errors by the same
// numbers: a bound that is changed here changes there.)

namespace raylab::triangle_filter {

inline constexpr double u64 = unit_roundoff<double>;

// A triangle's vertices as seen from the ray's origin, in plain doubles: each coordinate is wrong by at most
// `roundings` u times the magnitude of its axis, and no larger than that magnitude.
struct Corners {
    Vec3d a, b, c;
    Vec3d magnitude;
    int roundings;
};

// The largest of three coordinates per axis, signs aside. (glm's min, max and abs of vectors call through pointers.)
template <class V>
[[gnu::always_inline]] inline Vec3d largest(const V& a, const V& b, const V& c) {
    const auto of = [](double p, double q, double r) { return std::max({std::abs(p), std::abs(q), std::abs(r)}); };
    return {of(a.x, b.x, c.x), of(a.y, b.y, c.y), of(a.z, b.z, c.z)};
}

[[gnu::always_inline]] inline Corners corners(const Ray& ray, const Triangle& triangle) {
    const Vec3d origin = convert<double>(ray.origin);
    const Vec3d a = convert<double>(triangle.a) - origin;
    const Vec3d b = convert<double>(triangle.b) - origin;
    const Vec3d c = convert<double>(triangle.c) - origin;
    return {a, b, c, largest(a, b, c), 1};
}

struct Volumes {
    double u, v, w, volume;
};

#include "raylab/geometry/filter/triple_product-inl.h"

// The volumes whose signs tell on which side of a triangle's edges a ray with direction d passes, and the triangle's
// own. The vertices are seen from the ray's origin.
[[gnu::always_inline]] inline Volumes triangle_volumes(const Vec3d& d, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    return {triple_product(d, b, c), triple_product(d, c, a), triple_product(d, a, b), triple_product(a, b, c)};
}

// The four volumes that decide, and how wrong they may be.
struct Filter : Volumes {
    double edge_error, volume_error;
};

// The bounds, after Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, DCG
// 18, 1997, orient3d stage A. A monomial D_x (a_y b_z) of an edge's volume has two coordinates and, on its way into the
// sum, five roundings of its own; a monomial of the triangle's volume has three coordinates. The sixth rounding covers
// those of the bound itself. Monomials are products of three floats, of six where a placement multiplies: in doubles
// they lie between 2^-894 and 2^780, so that nothing under- or overflows. (Always inline: called, it takes twice as
// long.)
[[gnu::always_inline]] inline Filter filter(const Ray& ray, const Corners& corners) {
    const auto& [a, b, c, m, roundings] = corners;
    const Vec3d d = convert<double>(ray.direction);
    const double edges = 2 * (std::abs(d.x) * (m.y * m.z) + std::abs(d.y) * (m.x * m.z) + std::abs(d.z) * (m.x * m.y));
    const double volumes = 6 * (m.x * (m.y * m.z));
    return {triangle_volumes(d, a, b, c), (2 * roundings + 6) * u64 * edges, (3 * roundings + 6) * u64 * volumes};
}

struct Inaccurate {};  // a hit, but where?
using TriangleVerdict = std::variant<Undecided, Miss, Inaccurate, Candidate>;

enum class Range { inside, outside, unknown };

// Classifies volume / determinant: the sign of volume - t determinant, for an end t of the range, says on which side of
// it.
[[gnu::noinline]] inline Range where(double volume, double determinant, double determinant_error, double volume_error,
                                     const Interval<float>& range) {
    const auto beyond = [&](float t) { return volume - t * determinant; };
    const auto error = [&](float t) {
        return (volume_error + std::abs(t) * (determinant_error + 2 * u64 * determinant)) * (1 + 16 * u64);
    };
    if (beyond(range.min) < -error(range.min) || beyond(range.max) > error(range.max)) return Range::outside;
    if (!(beyond(range.min) > error(range.min))) return Range::unknown;
    return std::isinf(range.max) || beyond(range.max) < -error(range.max) ? Range::inside : Range::unknown;
}

[[gnu::always_inline]] inline TriangleVerdict decide(const Filter& f, const Interval<float>& range, Sides sides) {
    const double smallest = std::min({f.u, f.v, f.w});
    const double largest = std::max({f.u, f.v, f.w});
    if (smallest < -f.edge_error && largest > f.edge_error) return Miss{};
    if (!(smallest > f.edge_error) && !(largest < -f.edge_error)) return Undecided{};

    if (!sees(sides, sign(smallest))) return Miss{};
    const double side = smallest > 0 ? 1 : -1;
    const double determinant = side * (f.u + f.v + f.w);
    const double volume = side * f.volume;
    // Three edges' errors, and the rounding of their sum, which has no cancellation.
    const double determinant_error = 3 * f.edge_error + 3 * u64 * determinant;

    // volume / determinant - (volume + e) / (determinant + f) = (t f - e) / (determinant + f)
    const double t = volume / determinant;
    const double room = determinant - determinant_error;
    const double t_error =
        ((f.volume_error + std::abs(t) * determinant_error) / room + 2 * u64 * std::abs(t)) * (1 + 16 * u64);
    const bool surely_inside = room > 0 && t - t_error > range.min && t + t_error < range.max;
    if (!surely_inside) {
        const Range found = where(volume, determinant, determinant_error, f.volume_error, range);
        if (found == Range::outside) return Miss{};
        if (found == Range::unknown || !(room > 0)) return Undecided{};
    }
    if (!is_accurate(t, t_error)) return Inaccurate{};
    return Candidate{t, t_error, side * f.v / determinant, side * f.w / determinant};
}

}  // namespace raylab::triangle_filter
