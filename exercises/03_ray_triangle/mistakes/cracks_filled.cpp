// hint: own_tolerance
// Widens each edge by a hundred-thousandth of the triangle, against cracks in meshes.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    constexpr double rim = 1e-5;
    const Vec3d ab = triangle.b - triangle.a;
    const Vec3d ac = triangle.c - triangle.a;
    const Vec3d p = cross(ray.direction, ac);
    const double determinant = dot(ab, p);
    if (determinant == 0) return std::nullopt;
    const Vec3d s = ray.origin - triangle.a;
    const Vec3d q = cross(s, ab);
    const double u = dot(s, p) / determinant, v = dot(ray.direction, q) / determinant;
    if (u < -rim || v < -rim || u + v > 1 + rim) return std::nullopt;
    const double t = dot(ac, q) / determinant;
    if (!contains(ray.range, t)) return std::nullopt;
    return TriangleHit{t, u, v};
}
