#include "raylab/geometry/containment.h"

#include <cmath>

namespace raylab {

namespace {

using Number = Enclosure;

template <class Kind>
constexpr bool is_revolution = requires(const Kind& shape) { shape.ends; };

Region carried_back(const Region& point, const Affine& placement) {
    if (placement.is_identity()) return point;
    const auto& c = placement.columns;
    const Region x = convert<Number>(c[0]), y = convert<Number>(c[1]), z = convert<Number>(c[2]);
    const Region yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);  // the rows of the adjugate
    const Region from_origin = point - convert<Number>(placement.translation);
    const Number determinant = dot(x, yz);
    return {dot(yz, from_origin) / determinant, dot(zx, from_origin) / determinant, dot(xy, from_origin) / determinant};
}

// q(s) of shapes.h times |axis|^4, with s given as along = s |axis|^2.
struct SquaredRadius {
    Number q0, q1, q2;

    Number times(const Number& along, const Number& axis_squared) const {
        return (q0 * axis_squared + q1 * along) * axis_squared + q2 * along * along;
    }
};

Number number(float x) { return Number(double{x}); }

SquaredRadius squared_radius(const Cylinder& c) { return {number(c.radius) * number(c.radius), Number(0), Number(0)}; }
SquaredRadius squared_radius(const Cone& c) {
    const Number base = number(c.base_radius), growth = number(c.top_radius) - base;
    return {base * base, Number(2) * base * growth, growth * growth};
}
SquaredRadius squared_radius(const Paraboloid& p) {
    return {Number(0), number(p.radius) * number(p.radius), Number(0)};
}
SquaredRadius squared_radius(const Hyperboloid& h) {
    const Number growth = (number(h.radius) - number(h.waist)) * (number(h.radius) + number(h.waist));
    return {number(h.radius) * number(h.radius), Number(-4) * growth, Number(4) * growth};
}

// All of them positive: inside. One of them negative: outside.
template <std::size_t n>
Containment where_positive(const std::array<Number, n>& margins) {
    bool all = true;
    for (const auto& margin : margins) {
        if (sign(margin) == Sign::negative) return Containment::outside;
        all = all && sign(margin) == Sign::positive;
    }
    return all ? Containment::inside : Containment::undecided;
}

Containment where(const Region& p, const Sphere& sphere) {
    const Region d = p - convert<Number>(sphere.center);
    return where_positive<1>({number(sphere.radius) * number(sphere.radius) - dot(d, d)});
}

Containment where(const Region& p, const Ellipsoid& ellipsoid) {
    const Region d = p - convert<Number>(ellipsoid.center), r = convert<Number>(ellipsoid.radii);
    const Number x = d.x / r.x, y = d.y / r.y, z = d.z / r.z;
    return where_positive<1>({Number(1) - (x * x + y * y + z * z)});
}

template <class Kind>
    requires is_revolution<Kind>
Containment where(const Region& p, const Kind& shape) {
    if (shape.ends == Ends::open) return Containment::outside;
    const Region base = convert<Number>(shape.base), axis = convert<Number>(shape.top) - base, d = p - base;
    const Number along = dot(d, axis), axis_squared = dot(axis, axis);
    const Number rho_squared = dot(d, d) * axis_squared - along * along;  // times |axis|^2
    return where_positive<3>(
        {along, axis_squared - along, squared_radius(shape).times(along, axis_squared) - rho_squared * axis_squared});
}

Containment where(const Region&, const auto&) { return Containment::outside; }

// Whether all numbers of x lie on one side of the interval.
bool apart(const Number& x, float low, float high) { return x.upper() < low || x.lower() > high; }

Containment where_of_bounds(const Region& p, const Box& box) {
    const bool away =
        apart(p.x, box.min.x, box.max.x) || apart(p.y, box.min.y, box.max.y) || apart(p.z, box.min.z, box.max.z);
    return away ? Containment::outside : Containment::undecided;
}

bool is_mesh(const Shape& shape) { return std::holds_alternative<std::shared_ptr<const Mesh>>(shape); }

struct LiesInPlane {
    bool operator()(const Sphere&) const { return false; }
    bool operator()(const Ellipsoid&) const { return false; }
    template <class Kind>
        requires is_revolution<Kind>
    bool operator()(const Kind&) const {
        return false;
    }
    bool operator()(const Plane&) const { return true; }
    bool operator()(const Disk&) const { return true; }
    bool operator()(const Annulus&) const { return true; }
    bool operator()(const Polygon&) const { return true; }
    bool operator()(const Triangle&) const { return true; }
    bool operator()(const std::shared_ptr<const Mesh>&) const { return false; }
};

}  // namespace

bool is_closed(const Shape& shape) {
    return std::visit(
        []<class Kind>(const Kind& kind) {
            if constexpr (is_revolution<Kind>) return kind.ends == Ends::capped;
            return std::is_same_v<Kind, Sphere> || std::is_same_v<Kind, Ellipsoid>;
        },
        shape);
}

bool is_convex(const Shape& shape) { return is_closed(shape) && !std::holds_alternative<Hyperboloid>(shape); }

bool is_planar(const Shape& shape) { return std::visit(LiesInPlane{}, shape); }

Region region_about(const Vec3d& center, const Vec3d& reach) {
    return {{center.x, std::abs(reach.x)}, {center.y, std::abs(reach.y)}, {center.z, std::abs(reach.z)}};
}

Containment containment(const Region& region, const Shape& shape, const Affine& placement) {
    if (is_mesh(shape)) return containment_in_bounds(region, *bounds(shape), placement);
    const Region local = carried_back(region, placement);
    return std::visit([&](const auto& kind) { return where(local, kind); }, shape);
}

Containment containment_in_bounds(const Region& region, const Box& box, const Affine& placement) {
    return where_of_bounds(carried_back(region, placement), box);
}

}  // namespace raylab
