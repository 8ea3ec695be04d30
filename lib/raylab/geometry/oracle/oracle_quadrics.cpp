#include "raylab/geometry/oracle/oracle_cgal.h"

// A quadric's equation is read as it stands in shapes.h, with the line's point in it: a quadratic in t.

namespace raylab::oracle {

namespace {

struct Coordinates {
    InT x, y, z;
};

/// The line's points, seen from a center.
Coordinates coordinates(const Line& line, const Exact::Point_3& center) {
    const Exact::Vector_3 from = line.origin - center;
    const Exact::Vector_3& d = line.direction;
    return {{from.x(), d.x()}, {from.y(), d.y()}, {from.z(), d.z()}};
}

InT squared_length(const Coordinates& p) { return square(p.x) + square(p.y) + square(p.z); }

/// Outward is where the equation grows: its slope in t is the ray's way along the normal, its double zero a tangent.
HitKind meeting_at(CGAL::Sign slope) { return slope == CGAL::ZERO ? HitKind::tangent : HitKind::interior; }

/// A surface without ends: every zero is a hit.
Contacts intersect_closed(const InT& equation) {
    const Zeros zero = zeros(equation);
    Contacts contacts{{}, zero.everywhere};
    for (const auto& [t, slope] : zero.at) contacts.hits.push_back({meeting_at(slope), t, slope});
    return contacts;
}

/// rho^2 = q(s), a quadratic.
struct Revolution {
    Exact::Point_3 base;
    Exact::Vector_3 axis;
    InT q;
    Ends ends;
};

template <class Shape>
Revolution revolution(const Shape& shape, const InT& q) {
    const Exact::Point_3 base = exact_point(convert<double>(shape.base));
    return {base, exact_point(convert<double>(shape.top)) - base, q, shape.ends};
}

/// True if a point of the side at this s lies on its border. Where q is zero but not its slope, as at a paraboloid's
/// vertex, the side is smooth.
bool on_border(const Revolution& shape, const Root& s) {
    if (s == Root(0)) return shape.q.c0 != 0 || shape.q.c1 == 0;
    return s == Root(1);
}

Contacts intersect_side(const Line& line, const Revolution& shape) {
    const Coordinates p = coordinates(line, shape.base);
    const Rational length = shape.axis.squared_length();
    const InT s = 1 / length * (shape.axis.x() * p.x + shape.axis.y() * p.y + shape.axis.z() * p.z);
    const InT rho_squared = squared_length(p) - length * square(s);
    const Zeros zero = zeros(rho_squared - (InT{shape.q.c0, 0} + shape.q.c1 * s + shape.q.c2 * square(s)));
    Contacts contacts{{}, zero.everywhere};
    for (const auto& [t, slope] : zero.at) {
        const Root place = Root(s.c0) + s.c1 * t;
        if (place < Root(0) || place > Root(1)) continue;
        contacts.hits.push_back({on_border(shape, place) ? HitKind::boundary : meeting_at(slope), t, slope});
    }
    return contacts;
}

/// The disk that closes the surface at s = 0 or s = 1.
Contacts intersect_cap(const Line& line, const Revolution& shape, const Rational& s) {
    const Rational squared_radius = shape.q.c0 + shape.q.c1 * s + shape.q.c2 * s * s;
    if (squared_radius == 0) return {};
    const Exact::Point_3 center = shape.base + s * shape.axis;
    const Piercing piercing = pierce(line, center, s == 0 ? -shape.axis : shape.axis);
    if (!piercing.t) return {{}, piercing.within};
    const auto beyond = CGAL::compare(CGAL::squared_distance(at(line, *piercing.t), center), squared_radius);
    if (beyond == CGAL::LARGER) return {};
    return {{piercing.contact(beyond == CGAL::EQUAL ? HitKind::boundary : HitKind::interior)}, false};
}

Contacts intersect_revolution(const Line& line, const Revolution& shape) {
    if (shape.axis == CGAL::NULL_VECTOR) return {};
    Contacts contacts = intersect_side(line, shape);
    if (shape.ends == Ends::open) return contacts;
    for (const int s : {0, 1}) {
        const Contacts cap = intersect_cap(line, shape, s);
        contacts.hits.insert(contacts.hits.end(), cap.hits.begin(), cap.hits.end());
        contacts.within = contacts.within || cap.within;
    }
    return contacts;
}

}  // namespace

Contacts intersect_line(const Line& line, const SphereOf<double>& sphere) {
    if (sphere.radius < 0) return {};
    const Rational radius = exact(sphere.radius);
    return intersect_closed(squared_length(coordinates(line, exact_point(sphere.center))) - InT{radius * radius, 0});
}

Contacts intersect_line(const Line& line, const Ellipsoid& ellipsoid) {
    const Vec3d radii = convert<double>(ellipsoid.radii);
    if (radii.x <= 0 || radii.y <= 0 || radii.z <= 0) return {};
    const auto [x, y, z] = coordinates(line, exact_point(convert<double>(ellipsoid.center)));
    const auto over = [](const InT& coordinate, double radius) { return 1 / exact(radius) * coordinate; };
    return intersect_closed(squared_length({over(x, radii.x), over(y, radii.y), over(z, radii.z)}) - InT{1, 0});
}

Contacts intersect_line(const Line& line, const Cylinder& cylinder) {
    if (cylinder.radius < 0) return {};
    const InT radius{exact(cylinder.radius), 0};
    return intersect_revolution(line, revolution(cylinder, square(radius)));
}

Contacts intersect_line(const Line& line, const Cone& cone) {
    if (cone.base_radius < 0 || cone.top_radius < 0) return {};
    const InT radius{exact(cone.base_radius), exact(cone.top_radius) - exact(cone.base_radius)};
    return intersect_revolution(line, revolution(cone, square(radius)));
}

Contacts intersect_line(const Line& line, const Paraboloid& paraboloid) {
    if (paraboloid.radius < 0) return {};
    const InT squared_radius{0, CGAL::square(exact(paraboloid.radius))};
    return intersect_revolution(line, revolution(paraboloid, squared_radius));
}

Contacts intersect_line(const Line& line, const Hyperboloid& hyperboloid) {
    if (hyperboloid.waist < 0 || hyperboloid.radius < 0) return {};
    const Rational waist = CGAL::square(exact(hyperboloid.waist)), end = CGAL::square(exact(hyperboloid.radius));
    const InT squared_radius = InT{waist, 0} + (end - waist) * square(InT{-1, 2});
    return intersect_revolution(line, revolution(hyperboloid, squared_radius));
}

Answer intersect(const RayOf<double>& ray, const SphereOf<double>& sphere, Sides sides) {
    return answer(intersect_line(exact_line(ray), sphere), ray.range, sides);
}

}  // namespace raylab::oracle
