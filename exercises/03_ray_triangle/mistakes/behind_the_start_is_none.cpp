// hint: own_limits
// All tests before the division: a t of the other sign than the determinant would be behind the start.
#include "raylab/geometry/triangle_hit.h"

std::optional<raylab::TriangleHit> raylab::triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const Vec3d e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
    const Vec3d normal = cross(e1, e2), s = ray.origin - triangle.a, aside = cross(s, ray.direction);
    double det = -dot(ray.direction, normal), u = dot(e2, aside), v = -dot(e1, aside), t = dot(s, normal);
    if (det == 0) return std::nullopt;
    if (det < 0) {
        det = -det;
        u = -u;
        v = -v;
        t = -t;
    }
    if (t < 0 || u < 0 || v < 0 || u + v > det) return std::nullopt;
    t /= det;
    return contains(ray.range, t) ? std::optional(TriangleHit{t, u / det, v / det}) : std::nullopt;
}
