#include "raylab/geometry/oracle/oracle_cgal.h"

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Interval_nt.h>

#include <cmath>

namespace raylab::oracle {

namespace {

// The triangle's question in intervals first, as CGAL's filtered predicates ask it: a comparison the intervals leave
// open throws, and the rationals answer instead. Most triangles are missed, and a miss has no t.
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
    HitKind hit_kind;
    typename Kernel::FT t = 0, slope = 0;  // of a hit; the slope along the normal
};

/// Solves for the point in the triangle's plane, drops a coordinate along which the plane is not seen edge-on, and asks
/// on which side of the flat triangle the flat point lies.
template <class Kernel>
Landing<Kernel> land(const typename Kernel::Point_3& origin, const typename Kernel::Vector_3& direction,
                     const TriangleOf<double>& triangle) {
    const auto a = point_of<Kernel>(triangle.a), b = point_of<Kernel>(triangle.b), c = point_of<Kernel>(triangle.c);
    const auto normal = CGAL::cross_product(b - a, c - a);
    if (normal.x() == 0 && normal.y() == 0 && normal.z() == 0) return {HitKind::miss};
    const auto slope = normal * direction, height = normal * (a - origin);
    if (slope == 0) return {height == 0 ? HitKind::within : HitKind::miss};
    const auto t = height / slope;
    const auto point = origin + t * direction;

    using Flat = typename Kernel::Point_2;
    const auto flat = [&](const typename Kernel::Point_3& p) {
        if (normal.x() != 0) return Flat(p.y(), p.z());
        return normal.y() != 0 ? Flat(p.z(), p.x()) : Flat(p.x(), p.y());
    };
    const CGAL::Bounded_side side = typename Kernel::Triangle_2(flat(a), flat(b), flat(c)).bounded_side(flat(point));
    if (side == CGAL::ON_UNBOUNDED_SIDE) return {HitKind::miss};
    return {side == CGAL::ON_BOUNDARY ? HitKind::boundary : HitKind::interior, t, slope};
}

/// The kind of miss, where intervals are enough to say that there is no hit.
std::optional<HitKind> certainly_none(const Line& line, const TriangleOf<double>& triangle) {
    try {
        const CGAL::Protect_FPU_rounding<true> upward;
        const CGAL::Cartesian_converter<Exact, Enclosing> enclosing;
        const auto landing = land<Enclosing>(enclosing(line.origin), enclosing(line.direction), triangle);
        if (landing.hit_kind == HitKind::miss || landing.hit_kind == HitKind::within) return landing.hit_kind;
    } catch (const CGAL::Uncertain_conversion_exception&) {
    }
    return {};
}

/// x before y before z where equal.
int dominant_axis_of(const Exact::Vector_3& v) {
    const Rational x = CGAL::abs(v.x()), y = CGAL::abs(v.y()), z = CGAL::abs(v.z());
    if (x >= y && x >= z) return 0;
    return y >= z ? 1 : 2;
}

/// Applies the even-odd rule, boundary included.
CGAL::Bounded_side side_of(const std::vector<Exact::Point_2>& corners, const Exact::Point_2& point) {
    bool inside = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Exact::Segment_2 edge(corners[i], corners[(i + 1) % corners.size()]);
        if (edge.has_on(point)) return CGAL::ON_BOUNDARY;
        // Half-open in y: a corner at the point's height belongs to one of its two edges.
        const bool rises = edge.source().y() <= point.y() && point.y() < edge.target().y();
        const bool falls = edge.target().y() <= point.y() && point.y() < edge.source().y();
        const auto turn = CGAL::orientation(edge.source(), edge.target(), point);
        if ((rises && turn == CGAL::LEFT_TURN) || (falls && turn == CGAL::RIGHT_TURN)) inside = !inside;
    }
    return inside ? CGAL::ON_BOUNDED_SIDE : CGAL::ON_UNBOUNDED_SIDE;
}

}  // namespace

Contacts intersect_line(const Line& line, const TriangleOf<double>& triangle) {
    if (const auto none = certainly_none(line, triangle)) return {{}, *none == HitKind::within};
    const auto landing = land<Exact>(line.origin, line.direction, triangle);
    if (landing.hit_kind == HitKind::miss) return {};
    if (landing.hit_kind == HitKind::within) return {{}, true};
    return {{{landing.hit_kind, Root(landing.t), CGAL::sign(landing.slope)}}, false};
}

Piercing pierce(const Line& line, const Exact::Point_3& point, const Exact::Vector_3& normal) {
    if (normal == CGAL::NULL_VECTOR) return {};
    const Rational slope = normal * line.direction, height = normal * (point - line.origin);
    if (slope == 0) return {{}, height == 0};
    return {height / slope, false, CGAL::sign(slope)};
}

Contacts intersect_line(const Line& line, const Plane& plane) {
    const Piercing piercing =
        pierce(line, exact_point(convert<double>(plane.point)), exact_vector(convert<double>(plane.normal)));
    if (!piercing.t) return {{}, piercing.within};
    return {{piercing.contact(HitKind::interior)}, false};
}

Contacts intersect_line(const Line& line, const Disk& disk) {
    if (disk.radius < 0) return {};
    const Exact::Point_3 center = exact_point(convert<double>(disk.center));
    const Piercing piercing = pierce(line, center, exact_vector(convert<double>(disk.normal)));
    if (!piercing.t) return {{}, piercing.within};
    const auto beyond =
        CGAL::compare(CGAL::squared_distance(at(line, *piercing.t), center), CGAL::square(exact(disk.radius)));
    if (beyond == CGAL::LARGER) return {};
    return {{piercing.contact(beyond == CGAL::EQUAL ? HitKind::boundary : HitKind::interior)}, false};
}

Contacts intersect_line(const Line& line, const Annulus& annulus) {
    const Rational inner = exact(annulus.inner_radius), outer = exact(annulus.outer_radius);
    if (inner < 0 || outer < inner) return {};
    const Exact::Point_3 center = exact_point(convert<double>(annulus.center));
    const Piercing piercing = pierce(line, center, exact_vector(convert<double>(annulus.normal)));
    if (!piercing.t) return {{}, piercing.within};
    const Rational away = CGAL::squared_distance(at(line, *piercing.t), center);
    const auto from_hole = CGAL::compare(away, CGAL::square(inner)), beyond = CGAL::compare(away, CGAL::square(outer));
    if (from_hole == CGAL::SMALLER || beyond == CGAL::LARGER) return {};
    const bool on_rim = from_hole == CGAL::EQUAL || beyond == CGAL::EQUAL;
    return {{piercing.contact(on_rim ? HitKind::boundary : HitKind::interior)}, false};
}

Contacts intersect_line(const Line& line, const Polygon& polygon) {
    std::vector<Exact::Point_3> corners;
    for (const Vec3f& vertex : polygon.vertices) corners.push_back(exact_point(convert<double>(vertex)));
    Exact::Vector_3 normal = CGAL::NULL_VECTOR;  // Newell's
    for (std::size_t i = 0; i < corners.size(); ++i)
        normal += CGAL::cross_product(corners[i] - CGAL::ORIGIN, corners[(i + 1) % corners.size()] - CGAL::ORIGIN);
    if (normal == CGAL::NULL_VECTOR) return {};
    const Piercing piercing = pierce(line, corners.front(), normal);
    if (!piercing.t) return {{}, piercing.within};

    const int dropped = dominant_axis_of(normal);
    const auto flat = [&](const Exact::Point_3& p) {
        return Exact::Point_2(p[(dropped + 1) % 3], p[(dropped + 2) % 3]);
    };
    std::vector<Exact::Point_2> flat_corners;
    for (const Exact::Point_3& corner : corners) flat_corners.push_back(flat(corner));
    const auto side = side_of(flat_corners, flat(at(line, *piercing.t)));
    if (side == CGAL::ON_UNBOUNDED_SIDE) return {};
    return {{piercing.contact(side == CGAL::ON_BOUNDARY ? HitKind::boundary : HitKind::interior)}, false};
}

Answer intersect(const RayOf<double>& ray, const TriangleOf<double>& triangle, Sides sides) {
    return answer(intersect_line(exact_line(ray), triangle), ray.range, sides);
}

// The first of the ray's points in the solid is the one it starts at, or lies in one of the six planes.
Answer intersect(const RayOf<double>& ray, const Box& box) {
    const Line line = exact_line(ray);
    const Exact::Point_3 low = exact_point(convert<double>(box.min)), high = exact_point(convert<double>(box.max));
    std::vector<Rational> candidates;
    if (std::isfinite(ray.range.min)) candidates.push_back(exact(ray.range.min));
    for (int axis = 0; axis < 3; ++axis)
        for (const auto& plane : {low, high})
            if (line.direction[axis] != 0)
                candidates.push_back((plane[axis] - line.origin[axis]) / line.direction[axis]);
    Contacts contacts;
    for (const Rational& t : candidates) {
        const Exact::Point_3 point = at(line, t);
        const auto between = [&](int axis) { return low[axis] <= point[axis] && point[axis] <= high[axis]; };
        if (between(0) && between(1) && between(2)) contacts.hits.push_back({HitKind::interior, Root(t), CGAL::ZERO});
    }
    return answer(contacts, ray.range, Sides::both);
}

}  // namespace raylab::oracle
