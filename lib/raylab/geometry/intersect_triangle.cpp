#include "raylab/geometry/meet_triangle.h"
#include "raylab/number/dyadic.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace raylab {

namespace {

constexpr double u64 = unit_roundoff<double>;

// The filter's bounds, after Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates,
// DCG 18, 1997, orient3d stage A. Each coordinate relative to the origin carries one rounding, so a monomial
// D_x (a_y b_z) of an edge's volume carries two of these and, on its way into the sum, five more: 7 u relative. A
// monomial of the triangle's volume has one rounded factor more: 8 u. The unit added covers the rounding of the bound
// itself. Monomials of floats lie between 2^-447 and 2^389: nothing under- or overflows.
constexpr double edge_roundings = 8 * u64;
constexpr double volume_roundings = 9 * u64;

struct Undecided {};
struct Miss {};
using Verdict = std::variant<Undecided, Miss, Candidate>;

// What holds for one ray against one triangle in plain doubles.
struct Filter {
    double u, v, w, volume;
    double edge_error, volume_error;
};

Filter filter(const Ray& ray, const Triangle& triangle) {
    const Vec3d origin = convert<double>(ray.origin);
    const Vec3d d = convert<double>(ray.direction);
    const Vec3d a = convert<double>(triangle.a) - origin;
    const Vec3d b = convert<double>(triangle.b) - origin;
    const Vec3d c = convert<double>(triangle.c) - origin;
    const double x = std::max({std::abs(a.x), std::abs(b.x), std::abs(c.x)});
    const double y = std::max({std::abs(a.y), std::abs(b.y), std::abs(c.y)});
    const double z = std::max({std::abs(a.z), std::abs(b.z), std::abs(c.z)});
    const double edges = 2 * (std::abs(d.x) * (y * z) + std::abs(d.y) * (x * z) + std::abs(d.z) * (x * y));
    const Vec3d bc = cross(b, c);
    return {dot(d, bc), dot(d, cross(c, a)), dot(d, cross(a, b)), dot(a, bc), edge_roundings * edges,
            volume_roundings * (6 * (x * (y * z)))};
}

Verdict decide(const Filter& f, const Interval<float>& range, Sides sides) {
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

    // The sign of volume - t determinant, for an end t of the range, says on which side of it the hit lies.
    const auto beyond = [&](float t) { return volume - t * determinant; };
    const auto error = [&](float t) {
        return (f.volume_error + std::abs(t) * (determinant_error + 2 * u64 * determinant)) * (1 + 16 * u64);
    };
    if (beyond(range.min) < -error(range.min) || beyond(range.max) > error(range.max)) return Miss{};
    if (!(beyond(range.min) > error(range.min))) return Undecided{};
    if (!std::isinf(range.max) && !(beyond(range.max) < -error(range.max))) return Undecided{};

    // volume / determinant - (volume + e) / (determinant + f) = (t f - e) / (determinant + f)
    const double t = volume / determinant;
    const double room = determinant - determinant_error;
    if (!(room > 0)) return Undecided{};
    const double t_error =
        ((f.volume_error + std::abs(t) * determinant_error) / room + 2 * u64 * std::abs(t)) * (1 + 16 * u64);
    if (!is_accurate(t, t_error)) return Undecided{};
    return Candidate{t, t_error, side * f.v / determinant, side * f.w / determinant};
}

std::optional<Candidate> exactly(const Ray& ray, const Triangle& triangle, const Affine& placement, Sides sides) {
    Signs<Dyadic> signs;
    const auto found = crossing(local_ray<Dyadic>(ray, placement), triangle, sides, signs);
    if (!found) return std::nullopt;
    const Enclosure t = value(found->t());
    const Dyadic determinant = found->determinant();
    return Candidate{t.middle(), t.radius(), quotient(found->v, determinant), quotient(found->w, determinant)};
}

}  // namespace

std::optional<Candidate> intersect(const Ray& ray, const Triangle& triangle, Decisions& decisions, Sides sides) {
    const Verdict verdict = decide(filter(ray, triangle), ray.range, sides);
    if (const auto* candidate = std::get_if<Candidate>(&verdict)) return *candidate;
    if (std::holds_alternative<Miss>(verdict)) return std::nullopt;
    ++decisions.exact;
    return exactly(ray, triangle, {}, sides);
}

std::optional<Candidate> intersect(const Ray& ray, const Triangle& triangle, const Affine& placement,
                                   Decisions& decisions, Sides sides) {
    if (placement.is_identity()) return intersect(ray, triangle, decisions, sides);
    // A triangle's image is the triangle of the images: shorter products than in the triangle's own coordinates.
    Signs<Enclosure> signs;
    const auto& m = placement.columns;
    const Vec3<Enclosure> x = convert<Enclosure>(m[0]), y = convert<Enclosure>(m[1]), z = convert<Enclosure>(m[2]);
    const Vec3<Enclosure> origin = convert<Enclosure>(placement.translation) - convert<Enclosure>(ray.origin);
    const auto relative = [&](const Vec3f& v) {
        return Enclosure(v.x) * x + Enclosure(v.y) * y + Enclosure(v.z) * z + origin;
    };
    const auto found = crossing<Enclosure>(convert<Enclosure>(ray.direction),
                                           {relative(triangle.a), relative(triangle.b), relative(triangle.c)}, ray.range, signs);
    const bool seen = !found || sides == Sides::both ||
                      sees(sides, signs.of(found->determinant()) * signs.of(dot(x, cross(y, z))));
    if (!signs.undecided()) {
        if (!found || !seen) return std::nullopt;
        const Enclosure t = value(found->t()), determinant = found->determinant();
        if (is_accurate(t.middle(), t.radius())) {
            return Candidate{t.middle(), t.radius(), (found->v / determinant).middle(), (found->w / determinant).middle()};
        }
    }
    ++decisions.exact;
    return exactly(ray, triangle, placement, sides);
}

}  // namespace raylab
