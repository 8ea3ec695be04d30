#include "raylab/geometry/oracle_kernels.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intersections_3/Ray_3_Triangle_3.h>

namespace raylab::oracle {

namespace {

template <class Kernel>
bool hits(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    using Point = typename Kernel::Point_3;
    const auto point = [](const Vec3d& v) { return Point(v.x, v.y, v.z); };
    const Point origin = point(ray.origin);
    const typename Kernel::Vector_3 direction(ray.direction.x, ray.direction.y, ray.direction.z);
    const Point second = origin + direction;
    const typename Kernel::Triangle_3 flat(point(triangle.a), point(triangle.b), point(triangle.c));
    // Degenerate arguments break CGAL's preconditions: a ray without direction goes nowhere, no area is never met.
    if (second == origin || flat.is_degenerate()) return false;
    return CGAL::do_intersect(typename Kernel::Ray_3(origin, second), flat);
}

}  // namespace

bool epeck_hits(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    return hits<CGAL::Exact_predicates_exact_constructions_kernel>(ray, triangle);
}

bool epick_hits(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    return hits<CGAL::Exact_predicates_inexact_constructions_kernel>(ray, triangle);
}

}  // namespace raylab::oracle
