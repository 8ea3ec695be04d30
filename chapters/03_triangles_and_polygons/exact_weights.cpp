#include "exact_weights.h"

#include <gmpxx.h>

namespace raylab {

namespace {

using Exact = Triple<mpq_class>;

Exact exact(const Vec3f& v) { return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)}; }

}  // namespace

std::optional<Weights> exact_weights(const Ray& ray, const Triangle& triangle) {
    const Exact o = exact(ray.origin), d = exact(ray.direction);
    const Exact a = exact(triangle.a) - o, b = exact(triangle.b) - o, c = exact(triangle.c) - o;
    const mpq_class u = dot(d, cross(c, a)), v = dot(d, cross(a, b));
    const mpq_class whole = dot(d, cross(b, c)) + u + v;
    if (sgn(whole) == 0) return std::nullopt;
    return Weights{mpq_class(u / whole).get_d(), mpq_class(v / whole).get_d()};
}

}  // namespace raylab
