#include "raylab/geometry/oracle/cgal_ray.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

namespace raylab::oracle {

namespace {

template <class Kernel>
bool do_intersect_in(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    const auto point = [](const Vec3d& v) { return typename Kernel::Point_3(v.x, v.y, v.z); };
    const auto& d = ray.direction;
    const typename Kernel::Ray_3 cgal_ray(point(ray.origin), typename Kernel::Vector_3(d.x, d.y, d.z));
    if (cgal_ray.is_degenerate()) return false;  // the whole direction was rounded away
    const typename Kernel::Triangle_3 cgal_triangle(point(triangle.a), point(triangle.b), point(triangle.c));
    return CGAL::do_intersect(cgal_ray, cgal_triangle);
}

}  // namespace

bool cgal_do_intersect(CgalKernel kernel, const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    if (kernel == CgalKernel::epick)
        return do_intersect_in<CGAL::Exact_predicates_inexact_constructions_kernel>(ray, triangle);
    return do_intersect_in<CGAL::Exact_predicates_exact_constructions_kernel>(ray, triangle);
}

}  // namespace raylab::oracle
