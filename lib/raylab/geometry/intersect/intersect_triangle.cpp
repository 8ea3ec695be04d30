#include "raylab/geometry/filter/triangle_filter.h"
#include "raylab/geometry/filter/triangle_from_vertex.h"
#include "raylab/geometry/predicate/triangle_intersection.h"
#include "raylab/geometry/predicate/verdict.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab {

namespace {

using namespace triangle_filter;

const Affine at_rest;

// What is added to a vertex on the way to its image as seen from the ray's origin: each coordinate is wrong by at most
// `roundings` u times its size, and no larger than that.
struct Shift {
    Vec3d by, size;
    int roundings;
};

// glm's abs of vectors calls through a pointer.
Vec3d sizes(const Vec3d& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

Shift shift(const Ray& ray, const Affine& placement) {
    const Vec3d by = convert<double>(placement.translation) - convert<double>(ray.origin);
    return {by, sizes(by), 1};
}

// The product of time and speed is exact. The size has room for the two roundings of the sums and for its own.
Shift shift(const Ray& ray, const Affine& placement, const Motion& motion) {
    const Vec3d way = double{ray.time} * convert<double>(motion.translation);
    const Vec3d translation = convert<double>(placement.translation) + way, origin = convert<double>(ray.origin);
    return {translation - origin, sizes(translation) + sizes(origin), 3};
}

// A triangle's image is the triangle of the images. A coordinate m_x x + m_y y + m_z z + shift has exact products and,
// beside the shift's, three roundings of partial sums no larger than its terms' magnitudes together.
Corners corners(const Triangle& triangle, const std::array<Vec3f, 3>& columns, const Shift& shift) {
    const Vec3d x = convert<double>(columns[0]), y = convert<double>(columns[1]), z = convert<double>(columns[2]);
    const auto image = [&](const Vec3f& v) { return x * double{v.x} + y * double{v.y} + z * double{v.z} + shift.by; };
    const Vec3d v = largest(triangle.a, triangle.b, triangle.c);
    const auto along = [&](int i) {
        return std::abs(x[i]) * v.x + std::abs(y[i]) * v.y + std::abs(z[i]) * v.z + shift.size[i];
    };
    return {
        image(triangle.a), image(triangle.b), image(triangle.c), {along(0), along(1), along(2)}, shift.roundings + 4};
}

// The same where the linear part is the identity: one sum.
Corners corners(const Triangle& triangle, const Shift& shift) {
    const auto image = [&](const Vec3f& v) { return convert<double>(v) + shift.by; };
    return {image(triangle.a), image(triangle.b), image(triangle.c),
            largest(triangle.a, triangle.b, triangle.c) + shift.size, shift.roundings + 2};
}

double quotient(const Enclosure& a, const Enclosure& b) { return a.middle() / b.middle(); }

/// The question in numbers of any type: they say for themselves how sure they are.
template <Scalar T>
FilterVerdict decide_in(const TransformedRay<T>& ray, const Triangle& triangle, Sides sides) {
    Signs<T> signs;
    const auto found = crossing(ray, triangle, sides, signs);
    if (signs.undecided()) return Undecided{};
    if (!found) return Miss{};
    const Enclosure t = value(found->t());
    const T determinant = found->determinant();
    return Candidate{t.middle(), t.radius(), quotient(found->v, determinant), quotient(found->w, determinant)};
}

std::optional<Candidate> decide_beyond_doubles(const Ray& ray, const Triangle& triangle, const Affine& placement,
                                               Sides sides, DecisionCounts& decisions) {
    return decide_beyond_doubles(
        [&]<Scalar T>() { return decide_in<T>(transformed_ray<T>(ray, placement), triangle, sides); }, decisions);
}

// The side of the image that a side of the triangle becomes: a mirror turns the image's vertices round, not the normal.
std::optional<Sides> sides_of_image(Sides sides, const Affine& placement) {
    if (sides == Sides::both) return sides;
    const auto& m = placement.columns;
    const auto handedness =
        sign(dot(convert<Enclosure>(m[0]), cross(convert<Enclosure>(m[1]), convert<Enclosure>(m[2]))));
    if (!handedness) return std::nullopt;
    if (*handedness == Sign::positive) return sides;
    return sides == Sides::front ? Sides::back : Sides::front;
}

// Doubles about a triangle where it stands at the ray's time. A monomial of its volumes is a product of six floats, as
// where it is placed at rest: the way is a coordinate's own product of two. Where the linear part moves it would be one
// of nine, which may underflow: enclosures know.
FilterVerdict filter_moving(const Ray& ray, const Triangle& triangle, const Affine& placement, const Motion& motion,
                            Sides sides) {
    if (!only_translates(motion))
        return if_accurate(decide_in<Enclosure>(transformed_ray<Enclosure>(ray, placement, motion), triangle, sides));
    const auto of_image = sides_of_image(sides, placement);
    if (!of_image) return Undecided{};
    const Shift by = shift(ray, placement, motion);
    const Corners image =
        only_translates(placement, motion) ? corners(triangle, by) : corners(triangle, placement.columns, by);
    const TriangleVerdict decision = decide(filter(ray, image), ray.range, *of_image);
    if (const auto* candidate = std::get_if<Candidate>(&decision)) return *candidate;
    return std::holds_alternative<Miss>(decision) ? FilterVerdict(Miss{}) : FilterVerdict(Undecided{});
}

}  // namespace

std::optional<Candidate> intersect(const Ray& ray, const Triangle& triangle, DecisionCounts& decisions, Sides sides) {
    const TriangleVerdict decision = decide(filter(ray, corners(ray, triangle)), ray.range, sides);
    if (const auto* candidate = std::get_if<Candidate>(&decision)) return *candidate;
    if (std::holds_alternative<Miss>(decision)) return std::nullopt;
    if (std::holds_alternative<Inaccurate>(decision)) {
        if (const auto candidate = hit_from_vertex(ray, triangle)) return candidate;
    }
    return decide_beyond_doubles(ray, triangle, at_rest, sides, decisions);
}

std::optional<Candidate> intersect(const Ray& ray, const Triangle& triangle, const Affine& placement,
                                   DecisionCounts& decisions, Sides sides) {
    if (placement.is_identity()) return intersect(ray, triangle, decisions, sides);
    if (const auto of_image = sides_of_image(sides, placement)) {
        const Corners image = corners(triangle, placement.columns, shift(ray, placement));
        const TriangleVerdict decision = decide(filter(ray, image), ray.range, *of_image);
        if (const auto* candidate = std::get_if<Candidate>(&decision)) return *candidate;
        if (std::holds_alternative<Miss>(decision)) return std::nullopt;
    }
    return decide_beyond_doubles(ray, triangle, placement, sides, decisions);
}

std::optional<Candidate> intersect(const Ray& ray, const Triangle& triangle, const Affine& placement,
                                   const Motion& motion, DecisionCounts& decisions, Sides sides) {
    const FilterVerdict verdict = filter_moving(ray, triangle, placement, motion, sides);
    if (!std::holds_alternative<Undecided>(verdict)) return candidate_of(verdict);
    return decide_beyond_doubles(
        [&]<Scalar T>() { return decide_in<T>(transformed_ray<T>(ray, placement, motion), triangle, sides); },
        decisions);
}

}  // namespace raylab
