#include "raylab/geometry/oracle_numbers.h"

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Interval_nt.h>

namespace raylab::oracle {

namespace {

// The same question in intervals first, as CGAL's filtered predicates ask it: a comparison the intervals leave open
// throws, and the rationals answer instead. Most triangles are missed, and a miss has no t.
using Enclosing = CGAL::Simple_cartesian<CGAL::Interval_nt<false>>;

template <class Kernel>
typename Kernel::Point_3 point_of(const Vec3d& v) {
    return {v.x, v.y, v.z};
}
template <>
Exact::Point_3 point_of<Exact>(const Vec3d& v) {
    return exact_point(v);
}

template <class Kernel>
struct Landing {
    Meeting meeting;
    typename Kernel::FT t = 0;  // of a hit
};

/// Solves for the point in the triangle's plane, drops a coordinate along which the plane is not seen edge-on, and asks
/// on which side of the flat triangle the flat point lies.
template <class Kernel>
Landing<Kernel> land(const typename Kernel::Point_3& origin, const typename Kernel::Vector_3& direction,
                     const TriangleOf<double>& triangle) {
    const auto a = point_of<Kernel>(triangle.a), b = point_of<Kernel>(triangle.b), c = point_of<Kernel>(triangle.c);
    const auto normal = CGAL::cross_product(b - a, c - a);
    if (normal.x() == 0 && normal.y() == 0 && normal.z() == 0) return {Meeting::miss};
    const auto slope = normal * direction, height = normal * (a - origin);
    if (slope == 0) return {height == 0 ? Meeting::within : Meeting::miss};
    const auto t = height / slope;
    const auto point = origin + t * direction;

    using Flat = typename Kernel::Point_2;
    const auto flat = [&](const typename Kernel::Point_3& p) {
        if (normal.x() != 0) return Flat(p.y(), p.z());
        return normal.y() != 0 ? Flat(p.z(), p.x()) : Flat(p.x(), p.y());
    };
    const CGAL::Bounded_side side = typename Kernel::Triangle_2(flat(a), flat(b), flat(c)).bounded_side(flat(point));
    if (side == CGAL::ON_UNBOUNDED_SIDE) return {Meeting::miss};
    return {side == CGAL::ON_BOUNDARY ? Meeting::boundary : Meeting::interior, t};
}

/// Whether intervals are enough to say that there is no hit, and which kind of none.
std::optional<Meeting> certainly_none(const Line& line, const TriangleOf<double>& triangle) {
    try {
        const CGAL::Protect_FPU_rounding<true> upward;
        const CGAL::Cartesian_converter<Exact, Enclosing> enclosing;
        const auto landing = land<Enclosing>(enclosing(line.origin), enclosing(line.direction), triangle);
        if (landing.meeting == Meeting::miss || landing.meeting == Meeting::within) return landing.meeting;
    } catch (const CGAL::Uncertain_conversion_exception&) {
    }
    return {};
}

}  // namespace

Contacts meet_triangle(const Line& line, const TriangleOf<double>& triangle) {
    if (const auto none = certainly_none(line, triangle)) return {{}, *none == Meeting::within};
    const auto landing = land<Exact>(line.origin, line.direction, triangle);
    if (landing.meeting == Meeting::miss) return {};
    if (landing.meeting == Meeting::within) return {{}, true};
    return {{{landing.meeting, Root(landing.t)}}, false};
}

Answer meet(const RayOf<double>& ray, const TriangleOf<double>& triangle) {
    return answer(meet_triangle(exact_line(ray), triangle), ray.range);
}

}  // namespace raylab::oracle
