#pragma once

#include "raylab/geometry/predicate/accuracy.h"
#include "raylab/geometry/shapes.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace raylab {

/// The hit of a triangle that a ray is known to hit, with the origin moved to vertex a: s + t d = u e + v f by
/// Cramer's rule (Moeller & Trumbore, Journal of Graphics Tools 2(1), 1997). From far away the triangle's edges are
/// much shorter than the ways to its vertices, and so are the rounding errors. Absent: t or a weight is still not
/// accurate.
///
/// The bounds are counted as in intersect_triangle.cpp: each coordinate of s, e and f carries one rounding, d none;
/// each monomial takes five more on its way into its sum, and one is for the bound itself.
[[gnu::noinline]] inline std::optional<Candidate> hit_from_vertex(const Ray& ray, const Triangle& triangle) {
    const auto difference = [](const Vec3f& p, const Vec3f& q) { return convert<double>(p) - convert<double>(q); };
    const auto size = [](double x, double y) { return std::max(std::abs(x), std::abs(y)); };
    const auto sizes = [&](const Vec3d& x, const Vec3d& y) {
        return Vec3d{size(x.x, y.x), size(x.y, y.y), size(x.z, y.z)};
    };
    const Vec3d d = convert<double>(ray.direction), s = difference(ray.origin, triangle.a);
    const Vec3d e = difference(triangle.b, triangle.a), f = difference(triangle.c, triangle.a);
    const Vec3d d_size = sizes(d, d), s_size = sizes(s, s), edge_size = sizes(e, f);

    // The six monomials of a determinant, all taken positive.
    const auto monomials = [](const Vec3d& x, const Vec3d& y, const Vec3d& z) {
        return x.x * (y.y * z.z + y.z * z.y) + x.y * (y.x * z.z + y.z * z.x) + x.z * (y.x * z.y + y.y * z.x);
    };
    constexpr double u64 = unit_roundoff<double>;
    const Vec3d p = cross(d, f), q = cross(s, e);
    const Enclosure determinant(dot(e, p), 8 * u64 * monomials(d_size, edge_size, edge_size));
    const double weight_error = 8 * u64 * monomials(edge_size, s_size, d_size);
    const Enclosure u = Enclosure(dot(s, p), weight_error) / determinant;
    const Enclosure v = Enclosure(dot(d, q), weight_error) / determinant;
    const Enclosure t = Enclosure(dot(f, q), 9 * u64 * monomials(s_size, edge_size, edge_size)) / determinant;
    if (!is_accurate(t.middle(), t.radius()) || !(std::max(u.radius(), v.radius()) <= t_accuracy)) return std::nullopt;
    return Candidate{t.middle(), t.radius(), u.middle(), v.middle()};
}

}  // namespace raylab
