#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/ray.h"
#include "raylab/geometry/shapes.h"

#include <compare>
#include <memory>
#include <optional>
#include <string>

// Truth: every decision about a ray and a shape in exact arithmetic on CGAL, behind a plain header. It shares no
// formula with what it judges: it solves for the point of the carrying surface and then asks where that point lies.
// Slow (microseconds to milliseconds): for tests, charts and graders, never for pictures.
//
// Rays and triangles come as doubles, so that DOUBLE-INPUT can be judged too; floats convert exactly.

namespace raylab::oracle {

/// A ray parameter as an exact number: a rational or a root of a quadratic with rational coefficients.
class ExactT {
public:
    struct Value;
    explicit ExactT(std::shared_ptr<const Value> value);
    std::strong_ordering compare(const ExactT& other) const;
    std::strong_ordering compare(double other) const;
    double nearest() const;              // the double nearest to it
    double error_in_ulp(float t) const;  // |t - exact| in units of the last place of the float nearest to exact
    double error_in_ulp(double t) const;
    std::string to_string() const;  // "0.75 (3/4)", "0.5857864376269049 (smaller root of t^2 - 4 t + 2)", "2"

private:
    std::shared_ptr<const Value> value_;
};

/// The relation of a ray to a shape.
enum class HitKind {
    miss,
    interior,  // proper hit
    boundary,  // on an edge, a vertex, a rim
    tangent,   // touches a curved surface without crossing
    within,    // lies in the carrying surface (coplanar, along a generator): a miss, but a class of its own
};

struct Answer {
    HitKind hit_kind = HitKind::miss;  // of the hit at t; without one, of the first hit on the ray's whole line
    std::optional<ExactT> t;           // of the nearest hit seen inside the ray's closed range; absent: none there
    bool hit() const { return t.has_value(); }
};

Answer intersect(const RayOf<double>& ray, const TriangleOf<double>& triangle, Sides sides = Sides::both);
Answer intersect(const RayOf<double>& ray, const SphereOf<double>& sphere, Sides sides = Sides::both);

/// Any shape of a scene (a mesh: its nearest triangle) at its place: the exact image of the float shape under the map,
/// its normal carried by the inverse transpose.
Answer intersect(const RayOf<double>& ray, const Shape& shape, const Affine& placement = {}, Sides sides = Sides::both);

/// The same where the shape stands at a time, with nothing rounded on the way.
Answer intersect(const RayOf<double>& ray, const Shape& shape, const Affine& placement, const Motion& motion,
                 float time, Sides sides = Sides::both);

/// A box as a solid: its first point on the ray, wherever in the box that is. Finite.
Answer intersect(const RayOf<double>& ray, const Box& box);

/// The margin by which the answer does not flip, for graded cases that keep a margin: from 0 (exactly on a boundary,
/// coplanar, no surface) to 1, independent of scale, and relative to what a method that works in rounded numbers adds
/// up on the way. With R the distance from the ray's origin to the farthest vertex, a triangle's margin is the smallest
/// of: the areas that the hit point makes with the edges, and that of the whole triangle, as seen along the ray, over
/// R^2; the way along the ray from the hit to the ends of the range, over R. A miss is as safe as its clearest reason.
/// For a sphere of radius r at distance d from the origin: |r^2 - (distance of center and line)^2| / (d^2 + r^2), and
/// for a line that hits it the way from either hit to the ends of the range, over sqrt(d^2 + r^2).
double margin(const RayOf<double>& ray, const TriangleOf<double>& triangle);
double margin(const RayOf<double>& ray, const SphereOf<double>& sphere);

}  // namespace raylab::oracle
