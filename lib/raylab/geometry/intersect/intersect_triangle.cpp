#include "raylab/geometry/filter/triangle_filter.h"
#include "raylab/geometry/filter/triangle_from_vertex.h"
#include "raylab/geometry/predicate/triangle_intersection.h"
#include "raylab/geometry/predicate/verdict.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

using namespace triangle_filter;

const Affine at_rest;

// A triangle's image is the triangle of the images. A coordinate m_x x + m_y y + m_z z + (translation - origin) has
// exact products and four roundings of partial sums no larger than its terms' magnitudes together.
Corners corners(const Ray& ray, const Triangle& triangle, const Affine& placement) {
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

/// The question in numbers of any type: they say for themselves how sure they are.
template <Scalar T>
FilterVerdict decide_in(const Ray& ray, const Triangle& triangle, const Affine& placement, Sides sides) {
    Signs<T> signs;
    const auto found = crossing(transformed_ray<T>(ray, placement), triangle, sides, signs);
    if (signs.undecided()) return Undecided{};
    if (!found) return Miss{};
    const Enclosure t = value(found->t());
    const T determinant = found->determinant();
    return Candidate{t.middle(), t.radius(), quotient(found->v, determinant), quotient(found->w, determinant)};
}

std::optional<Candidate> decide_beyond_doubles(const Ray& ray, const Triangle& triangle, const Affine& placement,
                                               Sides sides, DecisionCounts& decisions) {
    return decide_beyond_doubles([&]<Scalar T>() { return decide_in<T>(ray, triangle, placement, sides); }, decisions);
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
        const TriangleVerdict decision = decide(filter(ray, corners(ray, triangle, placement)), ray.range, *of_image);
        if (const auto* candidate = std::get_if<Candidate>(&decision)) return *candidate;
        if (std::holds_alternative<Miss>(decision)) return std::nullopt;
    }
    return decide_beyond_doubles(ray, triangle, placement, sides, decisions);
}

}  // namespace raylab
