#pragma once

#include "raylab/geometry/oracle/oracle.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Root_of_traits.h>
#include <CGAL/Simple_cartesian.h>

#include <vector>

// Inside the oracle only: its exact numbers and points. Plain rationals, not CGAL's lazy ones: an answer may be shared
// between threads.

namespace raylab::oracle {

using Rational = CGAL::Gmpq;
using Root = CGAL::Root_of_traits<Rational>::Root_of_2;  // a0 + a1 sqrt(r), rational where a1 = 0
using Exact = CGAL::Simple_cartesian<Rational>;

struct ExactT::Value {
    Root t;
};

/// The points origin + t direction, exact; in a shape's own space where the shape was placed by a transform.
struct Line {
    Exact::Point_3 origin;
    Exact::Vector_3 direction;
};

Rational exact(double value);
Exact::Point_3 exact_point(const Vec3d& point);
Exact::Vector_3 exact_vector(const Vec3d& vector);
Line exact_line(const RayOf<double>& ray);

/// x against a double, which may be infinite.
std::strong_ordering compare(const Root& x, double y);

/// The double nearest to x, ties to even.
double nearest_double(const Root& x);

/// The contacts of the line of a ray with one shape or one part of it.
struct Contact {
    HitKind hit_kind;
    Root t;
    CGAL::Sign along_normal;  // positive: out through the back; zero: a tangent, an apex, seen from both sides
};
struct Contacts {
    std::vector<Contact> hits;
    bool within = false;  // the line lies in the surface of some part
};

/// The contract's answer, range included, from all hits of the whole line.
Answer answer(const Contacts& contacts, const Interval<double>& range, Sides sides);

/// c0 + c1 t + c2 t^2: what an equation becomes when a line's point is put into it.
struct InT {
    Rational c0, c1, c2 = 0;

    friend InT operator+(const InT& a, const InT& b) { return {a.c0 + b.c0, a.c1 + b.c1, a.c2 + b.c2}; }
    friend InT operator-(const InT& a, const InT& b) { return {a.c0 - b.c0, a.c1 - b.c1, a.c2 - b.c2}; }
    friend InT operator*(const Rational& s, const InT& a) { return {s * a.c0, s * a.c1, s * a.c2}; }
};

/// The square of a linear function of t.
InT square(const InT& linear);

/// The zeros of a quadratic: everywhere, or at its real roots in ascending order, a double root once.
struct Zeros {
    struct Zero {
        Root t;
        CGAL::Sign slope;  // whether the quadratic rises there; zero: a double root
    };
    bool everywhere = false;
    std::vector<Zero> at;
};
Zeros zeros(const InT& equation);

/// The crossing of a line and the plane through a point across a normal; a zero normal makes no plane.
struct Piercing {
    std::optional<Rational> t;
    bool within = false;
    CGAL::Sign along_normal = CGAL::ZERO;

    Contact contact(HitKind hit_kind) const { return {hit_kind, Root(*t), along_normal}; }
};
Piercing pierce(const Line& line, const Exact::Point_3& point, const Exact::Vector_3& normal);

/// The point of the line at a rational t.
inline Exact::Point_3 at(const Line& line, const Rational& t) { return line.origin + t * line.direction; }

// The contacts of a whole line with each shape.
Contacts intersect_line(const Line& line, const TriangleOf<double>& triangle);
Contacts intersect_line(const Line& line, const Plane& plane);
Contacts intersect_line(const Line& line, const Disk& disk);
Contacts intersect_line(const Line& line, const Annulus& annulus);
Contacts intersect_line(const Line& line, const Polygon& polygon);
Contacts intersect_line(const Line& line, const SphereOf<double>& sphere);
Contacts intersect_line(const Line& line, const Ellipsoid& ellipsoid);
Contacts intersect_line(const Line& line, const Cylinder& cylinder);
Contacts intersect_line(const Line& line, const Cone& cone);
Contacts intersect_line(const Line& line, const Paraboloid& paraboloid);
Contacts intersect_line(const Line& line, const Hyperboloid& hyperboloid);

}  // namespace raylab::oracle
