#include "raylab/geometry/meet_triangle.h"
#include "raylab/geometry/triangle_from_vertex.h"
#include "raylab/geometry/verdict.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

constexpr double u64 = unit_roundoff<double>;
const Affine at_rest;

// A triangle's vertices as seen from the ray's origin, in plain doubles: each coordinate is wrong by at most
// `roundings` u times the magnitude of its axis, and no larger than that magnitude.
struct Seen {
    Vec3d a, b, c;
    Vec3d magnitude;
    int roundings;
};

// The largest of three coordinates per axis, signs aside. (glm's min, max and abs of vectors call through pointers.)
template <class V>
Vec3d largest(const V& a, const V& b, const V& c) {
    const auto of = [](double p, double q, double r) { return std::max({std::abs(p), std::abs(q), std::abs(r)}); };
    return {of(a.x, b.x, c.x), of(a.y, b.y, c.y), of(a.z, b.z, c.z)};
}

Seen seen(const Ray& ray, const Triangle& triangle) {
    const Vec3d origin = convert<double>(ray.origin);
    const Vec3d a = convert<double>(triangle.a) - origin;
    const Vec3d b = convert<double>(triangle.b) - origin;
    const Vec3d c = convert<double>(triangle.c) - origin;
    return {a, b, c, largest(a, b, c), 1};
}

// A triangle's image is the triangle of the images. A coordinate m_x x + m_y y + m_z z + (translation - origin) has exact
// products and four roundings of partial sums no larger than its terms' magnitudes together.
Seen seen(const Ray& ray, const Triangle& triangle, const Affine& placement) {
    const Vec3d x = convert<double>(placement.columns[0]), y = convert<double>(placement.columns[1]);
    const Vec3d z = convert<double>(placement.columns[2]);
    const Vec3d origin = convert<double>(placement.translation) - convert<double>(ray.origin);
    const auto image = [&](const Vec3f& v) { return x * double{v.x} + y * double{v.y} + z * double{v.z} + origin; };
    const Vec3d v = largest(triangle.a, triangle.b, triangle.c);
    const auto along = [&](int i) {
        return std::abs(x[i]) * v.x + std::abs(y[i]) * v.y + std::abs(z[i]) * v.z + std::abs(origin[i]);
    };
    return {image(triangle.a), image(triangle.b), image(triangle.c), {along(0), along(1), along(2)}, 5};
}

// The four volumes that decide, and how wrong they may be.
struct Filter {
    double u, v, w, volume;
    double edge_error, volume_error;
};

// The bounds, after Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, DCG 18,
// 1997, orient3d stage A. A monomial D_x (a_y b_z) of an edge's volume has two coordinates and, on its way into the sum,
// five roundings of its own; a monomial of the triangle's volume has three coordinates. The sixth rounding covers those
// of the bound itself. Monomials are products of three floats, of six where a placement multiplies: in doubles they lie
// between 2^-894 and 2^780, so that nothing under- or overflows. (Always inline: called, it takes twice as long.)
[[gnu::always_inline]] inline Filter filter(const Ray& ray, const Seen& seen) {
    const auto& [a, b, c, m, roundings] = seen;
    const Vec3d d = convert<double>(ray.direction);
    const double edges = 2 * (std::abs(d.x) * (m.y * m.z) + std::abs(d.y) * (m.x * m.z) + std::abs(d.z) * (m.x * m.y));
    const double volumes = 6 * (m.x * (m.y * m.z));
    const Vec3d bc = cross(b, c);
    return {dot(d, bc), dot(d, cross(c, a)), dot(d, cross(a, b)), dot(a, bc), (2 * roundings + 6) * u64 * edges,
            (3 * roundings + 6) * u64 * volumes};
}

struct Inaccurate {};  // a hit, but where?
using Decision = std::variant<Undecided, Miss, Inaccurate, Candidate>;

enum class Range { inside, outside, unknown };

// Where volume / determinant lies: the sign of volume - t determinant, for an end t of the range, says on which side of it.
[[gnu::noinline]] Range where(double volume, double determinant, double determinant_error, double volume_error,
                              const Interval<float>& range) {
    const auto beyond = [&](float t) { return volume - t * determinant; };
    const auto error = [&](float t) {
        return (volume_error + std::abs(t) * (determinant_error + 2 * u64 * determinant)) * (1 + 16 * u64);
    };
    if (beyond(range.min) < -error(range.min) || beyond(range.max) > error(range.max)) return Range::outside;
    if (!(beyond(range.min) > error(range.min))) return Range::unknown;
    return std::isinf(range.max) || beyond(range.max) < -error(range.max) ? Range::inside : Range::unknown;
}

[[gnu::always_inline]] inline Decision decide(const Filter& f, const Interval<float>& range, Sides sides) {
    const double least = std::min({f.u, f.v, f.w});
    const double most = std::max({f.u, f.v, f.w});
    if (least < -f.edge_error && most > f.edge_error) return Miss{};
    if (!(least > f.edge_error) && !(most < -f.edge_error)) return Undecided{};

    if (!sees(sides, sign(least))) return Miss{};
    const double side = least > 0 ? 1 : -1;
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

/// The question in numbers of any type: they say for themselves how sure they are.
template <Scalar T>
FilterVerdict decide_in(const Ray& ray, const Triangle& triangle, const Affine& placement, Sides sides) {
    Signs<T> signs;
    const auto found = crossing(local_ray<T>(ray, placement), triangle, sides, signs);
    if (signs.undecided()) return Undecided{};
    if (!found) return Miss{};
    const Enclosure t = value(found->t());
    const T determinant = found->determinant();
    return Candidate{t.middle(), t.radius(), quotient(found->v, determinant), quotient(found->w, determinant)};
}

std::optional<Candidate> settle(const Ray& ray, const Triangle& triangle, const Affine& placement, Sides sides,
                                Decisions& decisions) {
    return settle([&]<Scalar T>() { return decide_in<T>(ray, triangle, placement, sides); }, decisions);
}

// Which side of the image is meant by a side of the triangle: a mirror turns the image's vertices round, not the normal.
std::optional<Sides> sides_of_image(Sides sides, const Affine& placement) {
    if (sides == Sides::both) return sides;
    const auto& m = placement.columns;
    const auto handedness = sign(dot(convert<Enclosure>(m[0]), cross(convert<Enclosure>(m[1]), convert<Enclosure>(m[2]))));
    if (!handedness) return std::nullopt;
    if (*handedness == Sign::positive) return sides;
    return sides == Sides::front ? Sides::back : Sides::front;
}

}  // namespace

std::optional<Candidate> intersect(const Ray& ray, const Triangle& triangle, Decisions& decisions, Sides sides) {
    const Decision decision = decide(filter(ray, seen(ray, triangle)), ray.range, sides);
    if (const auto* candidate = std::get_if<Candidate>(&decision)) return *candidate;
    if (std::holds_alternative<Miss>(decision)) return std::nullopt;
    if (std::holds_alternative<Inaccurate>(decision)) {
        if (const auto candidate = hit_from_vertex(ray, triangle)) return candidate;
    }
    return settle(ray, triangle, at_rest, sides, decisions);
}

std::optional<Candidate> intersect(const Ray& ray, const Triangle& triangle, const Affine& placement,
                                   Decisions& decisions, Sides sides) {
    if (placement.is_identity()) return intersect(ray, triangle, decisions, sides);
    if (const auto of_image = sides_of_image(sides, placement)) {
        const Decision decision = decide(filter(ray, seen(ray, triangle, placement)), ray.range, *of_image);
        if (const auto* candidate = std::get_if<Candidate>(&decision)) return *candidate;
        if (std::holds_alternative<Miss>(decision)) return std::nullopt;
    }
    return settle(ray, triangle, placement, sides, decisions);
}

}  // namespace raylab
